package org.pendant.recording.compare;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.recording.Recording;

/**
 * Run track: what programs decided in a run, frame by frame from the switch-on: where the arm has
 * to be, digital outputs, lines of {@code textmsg}, and how long it took. One thread uses it.
 */
public final class RunTrack {
  /** Lines of text that are kept; a program that writes more is compared by the first ones. */
  private static final int MAX_TEXTS = 10_000;

  private final boolean withTcp;
  private final List<Sample> samples = new ArrayList<>();
  private final List<Switch> switches = new ArrayList<>();
  private final List<Text> texts = new ArrayList<>();
  private DigitalLevels levels = DigitalLevels.ALL_LOW;
  private final Within within;
  private long lastFrame;

  /**
   * By how much the places of a track may be off.
   *
   * @param deg joints, degrees
   * @param mm the TCP
   */
  public record Within(double deg, double mm) {
    private static final Within NOTHING = new Within(0, 0);
  }

  /**
   * An empty track.
   *
   * @param withTcp whether it keeps where the TCP has to be
   */
  public RunTrack(boolean withTcp) {
    this.withTcp = withTcp;
    within = Within.NOTHING;
  }

  /** One that was written down. */
  RunTrack(
      List<Sample> samples, List<Switch> switches, List<Text> texts, long lastFrame, Within off) {
    withTcp = samples.getFirst().tcp().isPresent();
    this.samples.addAll(samples);
    this.switches.addAll(switches);
    this.texts.addAll(texts);
    this.lastFrame = lastFrame;
    within = off;
  }

  /** What holds from a frame on, until the next one. */
  record Sample(long frame, Joints target, Optional<Pose> tcp, int line) {}

  /** An output that changes. */
  record Switch(long frame, Signal signal, boolean on) {}

  /** A line of text. */
  record Text(long frame, String text) {}

  /** That of a recording from its beginning to its end; too slow for the dispatch thread. */
  public static RunTrack of(Recording recording, boolean withTcp) {
    RunTrack track = new RunTrack(withTcp);
    recording.frames(recording.firstFrame(), recording.lastFrame(), track::take);
    track.lastFrame = recording.lastFrame();
    return track;
  }

  /** Takes the next frame; those in which nothing changes may be left out. */
  public void take(ControllerState state) {
    lastFrame = state.frame();
    takeArm(state);
    if (!state.io().equals(levels)) {
      takeOutputs(state);
    }
    for (LogEntry each : state.newEntries()) {
      if (each.origin() == LogEntry.Origin.SCRIPT && texts.size() < MAX_TEXTS) {
        texts.add(new Text(state.frame(), each.text()));
      }
    }
  }

  private void takeArm(ControllerState state) {
    Joints target = state.arm().targetPositionRad();
    int line = state.program().line();
    Optional<Pose> tcp =
        withTcp ? Optional.of(state.arm().targetTcpInBase()) : Optional.<Pose>empty();
    if (!samples.isEmpty()) {
      Sample last = samples.getLast();
      if (last.target().equals(target) && last.line() == line && last.tcp().equals(tcp)) {
        return;
      }
    }
    samples.add(new Sample(state.frame(), target, tcp, line));
  }

  private void takeOutputs(ControllerState state) {
    for (SignalBank bank : SignalBank.values()) {
      int changed = state.io().bits(bank) ^ levels.bits(bank);
      for (int i = 0; !bank.input() && bank != SignalBank.FLAG && i < bank.size(); i++) {
        if ((changed >> i & 1) != 0) {
          Signal signal = new Signal(bank, i);
          switches.add(new Switch(state.frame(), signal, state.io().level(signal)));
        }
      }
    }
    levels = state.io();
  }

  /** What holds in a frame; in one before the first what holds in the first. */
  Sample at(long frame) {
    int low = 0;
    int high = samples.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (samples.get(middle).frame() <= frame) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return samples.get(low);
  }

  /** Whether nothing has been taken. */
  public boolean isEmpty() {
    return samples.isEmpty();
  }

  /** By how much its places may be off. */
  public Within within() {
    return within;
  }

  /** Whether it has where the TCP has to be. */
  public boolean hasTcp() {
    return withTcp;
  }

  /** Where the joints have to be in a frame. */
  public Joints target(long frame) {
    return at(frame).target();
  }

  long firstFrame() {
    return samples.getFirst().frame();
  }

  /** The changes of all outputs, oldest first. */
  List<Switch> switches() {
    return switches;
  }

  long lastFrame() {
    return lastFrame;
  }

  /** The changes of a signal, oldest first. */
  List<Switch> switchesOf(Signal signal) {
    return switches.stream().filter(each -> each.signal().equals(signal)).toList();
  }

  /** Whether a signal is on at the end of a frame. */
  boolean level(Signal signal, long frame) {
    boolean on = false;
    for (Switch each : switches) {
      if (each.frame() > frame) {
        break;
      }
      on = each.signal().equals(signal) ? each.on() : on;
    }
    return on;
  }

  /** The lines of text, oldest first. */
  List<Text> texts() {
    return texts;
  }
}
