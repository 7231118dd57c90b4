package org.pendant.recording.whatif;

import java.util.Optional;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.lines.FrameMargins;
import org.pendant.recording.lines.Margin;

/** Variant measure: what a run takes from a moment on, frame by frame. Mutable. */
final class VariantMeasure {
  private static final int MAX_POINTS = 20_000;

  private final FrameMargins margins;
  private final TcpWay.Builder way = new TcpWay.Builder(MAX_POINTS);
  private final JointTrack.Builder track;
  private final Rounds rounds = new Rounds();
  private final ControllerState moment;
  private ControllerState newest;
  private Optional<Peak> torque = Optional.empty();
  private Optional<Peak> jointSpeed = Optional.empty();

  VariantMeasure(ControllerState moment, SafetyConfiguration safety) {
    this.moment = moment;
    newest = moment;
    margins = new FrameMargins(moment.arm(), safety);
    way.add(moment.arm().actualTcpInBase());
    track = new JointTrack.Builder(moment.frame(), MAX_POINTS);
    track.add(moment.frame(), moment.arm().actualPositionRad());
  }

  /** A frame has ended; one that a debugger holds counts when it is done. */
  void see(ControllerState state) {
    newest = state;
    if (state.debug().held()) {
      return;
    }
    margins.look(state);
    torque = higher(torque, Margin.TORQUE, state);
    jointSpeed = higher(jointSpeed, Margin.JOINT_SPEED, state);
    rounds.see(state.program().line(), state.frame());
    way.add(state.arm().actualTcpInBase());
    track.add(state.frame(), state.arm().actualPositionRad());
  }

  private Optional<Peak> higher(Optional<Peak> peak, Margin margin, ControllerState state) {
    double share = margins.value(margin);
    if (peak.isPresent() && peak.get().share() >= share) {
      return peak;
    }
    String joint = margins.part(margin, margins.part(margin));
    return Optional.of(new Peak(share, joint, state.program().line(), timeS()));
  }

  /** Robot time since the moment, s. */
  double timeS() {
    return (newest.frame() - moment.frame()) * FrameTime.FRAME_S;
  }

  Optional<Peak> torque() {
    return torque;
  }

  Optional<Peak> jointSpeed() {
    return jointSpeed;
  }

  Rounds.Round round() {
    return rounds.round();
  }

  double energyJ() {
    return newest.readings().energyConsumedJ() - moment.readings().energyConsumedJ();
  }

  TcpWay way() {
    return way.way();
  }

  JointTrack track() {
    return track.track();
  }
}
