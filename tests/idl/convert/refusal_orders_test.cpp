// Orders, answers, commands and injections that nobody of this run would send are refused by field and reason.
#include "tests/idl/convert/refusals.hpp"

namespace skein {
namespace {

using namespace refusals;
using enum WireFaultReason;

TEST(Refusal, Orders) {
  using W = wire::Tick;
  expect_refused<W>(to_wire(examples::tick(), examples::kStamp),
                    {{"tick.commands", OutOfRange, [](W& t) { t.commands().resize(17); }},
                     {"tick.commands", OutOfRange, [](W& t) { t.commands()[0].id(0); }},
                     {"tick.commands", UnknownAgent, [](W& t) { t.commands()[0].agent(257); }},
                     {"tick.commands", BadEnum, [](W& t) { t.commands()[0].kind(7); }},
                     {"tick.commands", NonFinite, [](W& t) { t.commands()[0].to_m().z(kNan); }},
                     {"tick.commands", OutOfRange, [](W& t) { t.commands()[0].speed_mps(-1.0); }},
                     {"tick.answers", OutOfRange, [](W& t) { t.answers().resize(17); }},
                     {"tick.answers.id", OutOfRange, [](W& t) { t.answers()[0].id(0); }},
                     {"tick.answers.result", BadEnum, [](W& t) { t.answers()[0].result(9); }},
                     {"tick.answers.text", OutOfRange, [](W& t) { t.answers()[1].text("a\nb"); }},
                     {"tick.answers.acknowledged", BadOrder, [](W& t) {
                        t.answers()[0].acknowledged({3, 1});
                      }}});
}

TEST(Refusal, CommandAndInject) {
  using W = wire::Command;
  expect_refused<W>(to_wire(examples::command(), examples::kStamp),
                    {{"command.head.run", WrongRun, [](W& c) { c.head().run(78); }},
                     {"command", OutOfRange, [](W& c) { c.id(0); }},
                     {"command", BadEnum, [](W& c) { c.kind(0); }},
                     {"command.deadline_s", NonFinite, [](W& c) { c.deadline_s(kNan); }}});
  using I = wire::Inject;
  expect_refused<I>(to_wire(examples::inject(), examples::kStamp),
                    {{"inject.head.run", WrongRun, [](I& i) { i.head().run(78); }},
                     {"inject.id", OutOfRange, [](I& i) { i.id(0); }},
                     {"inject.kind", BadEnum, [](I& i) { i.kind(5); }},
                     {"inject.agent", UnknownAgent, [](I& i) { i.agent(257); }},
                     {"inject.position_m", NonFinite, [](I& i) { i.position_m().x(kNan); }},
                     {"inject.radius_m", OutOfRange, [](I& i) { i.radius_m(-1.0); }}});
}

}  // namespace
}  // namespace skein
