#include "idl/convert/checker.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/parts.hpp"

namespace skein {
namespace {

wire::CellBlock wire_sight(const CellWindow& sight) {
  require_bound(sight.packed.size(), kMaxSightBytes, "sense.sight");
  wire::CellBlock out;
  out.i(sight.low.i);
  out.j(sight.low.j);
  out.k(sight.low.k);
  out.ni(sight.ni);
  out.nj(sight.nj);
  out.nk(sight.nk);
  out.packed(sight.packed);
  return out;
}

CellWindow plain_sight(const wire::CellBlock& block) {
  return {{block.i(), block.j(), block.k()}, block.ni(), block.nj(), block.nk(), block.packed()};
}

void check_heard(Checker& check, const std::vector<wire::HeardPeer>& heard, AgentId self) {
  check.size_at_most(heard.size(), kMaxAgents, "sense.heard");
  if (!check.ok()) return;
  AgentId before = 0;
  for (const wire::HeardPeer& peer : heard) {
    check.agent(peer.agent(), "sense.heard.agent");
    check.require(peer.agent() != self, WireFaultReason::UnknownAgent, "sense.heard.agent");
    check.require(peer.agent() > before, WireFaultReason::BadOrder, "sense.heard");
    check.position(peer.position_m(), "sense.heard.position_m");
    check.velocity(peer.velocity_mps(), "sense.heard.velocity_mps");
    before = peer.agent();
  }
}

/// The sizes agree with the bytes, and each cell is Free, Occupied or not seen.
void check_sight(Checker& check, const wire::CellBlock& block) {
  for (const std::int32_t place : {block.i(), block.j(), block.k()}) {
    check.require(place >= -limits::kCell && place <= limits::kCell, WireFaultReason::OutOfRange, "sense.sight.low");
  }
  for (const std::int32_t size : {block.ni(), block.nj(), block.nk()}) {
    check.require(size >= 0 && size <= limits::kCell, WireFaultReason::OutOfRange, "sense.sight.size");
  }
  check.size_at_most(block.packed().size(), kMaxSightBytes, "sense.sight.packed");
  if (!check.ok()) return;
  const double cells = static_cast<double>(block.ni()) * block.nj() * block.nk();
  check.require(cells <= 4.0 * kMaxSightBytes, WireFaultReason::OutOfRange, "sense.sight.size");
  if (!check.ok()) return;
  const CellWindow sight = plain_sight(block);
  check.require(sight.packed.size() == (sight.size() + 3) / 4, WireFaultReason::OutOfRange, "sense.sight.packed");
  if (!check.ok()) return;
  for (std::size_t n = 0; n < sight.size(); ++n) {
    check.require(sight.at(n) != CellState::Revisited, WireFaultReason::BadEnum, "sense.sight.packed");
  }
}

}  // namespace

wire::Sense to_wire(const Sense& sense, const Stamp& stamp) {
  require_bound(sense.heard.size(), kMaxAgents, "sense.heard");
  require_bound(sense.tracks.size(), wire::kMaxTracks, "sense.tracks");
  require_bound(sense.zones.size(), wire::kMaxAnnounced, "sense.zones");
  wire::Sense out;
  out.head(wire_head(sense.run, stamp.stamp_ns, kWorldId, sense.incarnation));
  out.agent(sense.agent);
  out.round(sense.round);
  out.own(wire_pose(sense.pose));
  out.velocity_mps(wire_point(sense.velocity_mps));
  out.heard().resize(sense.heard.size());
  for (std::size_t i = 0; i < sense.heard.size(); ++i) {
    wire::HeardPeer& peer = out.heard()[i];
    peer.agent(sense.heard[i].agent);
    peer.position_m(wire_point(sense.heard[i].position_m));
    peer.velocity_mps(wire_point(sense.heard[i].velocity_mps));
    peer.landed(sense.heard[i].landed);
  }
  out.sight(wire_sight(sense.sight));
  out.tracks(wire_tracks(sense.tracks));
  for (const ZoneState zone : sense.zones) out.zones().push_back(static_cast<std::uint8_t>(zone));
  out.obeyed(sense.obeyed);
  return out;
}

Checked<Sense> from_wire(const wire::Sense& sample, const WireContext& context) {
  Checker check(context);
  check.sender(sample.head(), kWorldId, "sense.head.sender");
  check.run(sample.head().run(), "sense.head.run");
  check.agent(sample.agent(), "sense.agent");
  check.incarnation(sample.agent(), sample.head().incarnation(), std::nullopt, "sense.head.incarnation");
  check.pose(sample.own(), "sense.own");
  check.velocity(sample.velocity_mps(), "sense.velocity_mps");
  check_heard(check, sample.heard(), sample.agent());
  check_sight(check, sample.sight());
  check.tracks(sample.tracks(), wire::kMaxTracks, "sense.tracks");
  check.size_at_most(sample.zones().size(), wire::kMaxAnnounced, "sense.zones");
  for (const std::uint8_t zone : sample.zones()) {
    check.enumerator(zone, ZoneState::Ahead, ZoneState::Clear, "sense.zones");
  }
  if (!check.ok()) return check.fault();

  Sense out;
  out.run = sample.head().run();
  out.agent = sample.agent();
  out.incarnation = sample.head().incarnation();
  out.round = sample.round();
  out.pose = plain_pose(sample.own());
  out.velocity_mps = plain_point(sample.velocity_mps());
  for (const wire::HeardPeer& peer : sample.heard()) {
    out.heard.push_back(
        {peer.agent(), plain_point(peer.position_m()), plain_point(peer.velocity_mps()), peer.landed()});
  }
  out.sight = plain_sight(sample.sight());
  out.tracks = plain_tracks(sample.tracks());
  for (const std::uint8_t zone : sample.zones()) out.zones.push_back(static_cast<ZoneState>(zone));
  out.obeyed = sample.obeyed();
  return out;
}

}  // namespace skein
