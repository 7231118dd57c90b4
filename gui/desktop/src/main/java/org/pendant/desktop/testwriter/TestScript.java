package org.pendant.desktop.testwriter;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.io.SignalWrite;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;
import org.pendant.testing.run.TestSettings;

/**
 * Test script: the text of a test that repeats a run: it does to the program what was done to it
 * then, and wants the outputs to change in the same order and the arm to end in the same place.
 */
public final class TestScript {
  /** Changes of outputs that are expected one by one. */
  static final int MAX_OUTPUTS = 100;

  /** By how much each joint may end elsewhere, degrees. */
  private static final double END_DEG = 0.5;

  private static final double SAME_RAD = 1e-4;

  /** By how much the program may be slower than it was, beside half a second. */
  private static final double SLOWER = 1.25;

  private static final double ALWAYS_S = 0.5;
  private static final double ALWAYS_SHARE = 0.9;
  private static final double SPARE_S = 30;

  private final OperatedRun facts;
  private final String program;
  private final UnaryOperator<String> names;
  private final List<String> lines = new ArrayList<>();

  /** Up to which frame of the run the test has come. */
  private long reached;

  private TestScript(OperatedRun facts, String program, UnaryOperator<String> names) {
    this.facts = facts;
    this.program = program;
    this.names = names;
  }

  /**
   * Writes a test.
   *
   * @param word what it is called after, such as the name of its file without endings
   * @param program the name of the file that it starts, from its own folder on
   * @param names the names that people gave to signals such as {@code digital_in[0]}; empty for
   *     none
   */
  public static String of(
      OperatedRun facts, String word, String program, UnaryOperator<String> names) {
    TestScript script = new TestScript(facts, program, names);
    script.write(TestPieces.function(word));
    return String.join("\n", script.lines) + "\n";
  }

  /** The name of the test that {@link #of} writes. */
  public static String function(String word) {
    return TestPieces.function(word);
  }

  /** A statement of a function, with a comment behind it. */
  static String line(String statement, Optional<String> note) {
    return "  " + statement + note.map(each -> "  # " + each).orElse("");
  }

  /** The argument that gives the program time for what took so many frames. */
  static String within(long frames) {
    return ", within=" + allowed(frames);
  }

  private static long allowed(long frames) {
    return (long) Math.ceil(frames * FrameTime.FRAME_S * SLOWER + 0.5);
  }

  private void write(String function) {
    head();
    List<String> operator = OperatorThread.lines(facts, names);
    if (!operator.isEmpty()) {
      lines.addAll(operator);
      lines.add("");
    }
    marks();
    lines.add("def " + function + "():");
    prepare();
    answers();
    add("start(\"" + program + "\")");
    if (!operator.isEmpty()) {
      add(OperatorThread.start());
    }
    outputs();
    end();
    lines.add("end");
  }

  private void head() {
    lines.add("# Written from a run of " + program + " that " + ending());
    lines.add(
        "# Each expectation has a quarter more time than the program took, and half a second.");
    if (!facts.left().isEmpty()) {
      lines.add("#");
      lines.add("# Not in this test:");
      facts.left().forEach(each -> lines.add("# - " + each));
    }
    lines.add("");
  }

  private String ending() {
    String after = RunFrames.text(facts.end().frame());
    return switch (facts.end()) {
      case RunEnd.Finished _ -> "took " + after + ".";
      case RunEnd.Stopped _ -> "was stopped after " + after + ".";
      case RunEnd.Failed _ -> "failed after " + after + ".";
      case RunEnd.Running _ -> "went on after " + after + ".";
      case RunEnd.Unsafe(_, String message) ->
          "the safety functions stopped after " + after + ": " + message;
    };
  }

  private void marks() {
    if (!near(facts.startRad(), BoxSetup.START_RAD)) {
      lines.add("# @start_at " + TestPieces.degrees(facts.startRad()));
    }
    double longestS = facts.end().frame() * FrameTime.FRAME_S * SLOWER + SPARE_S;
    if (longestS > TestSettings.STANDARD_TIMEOUT_S) {
      lines.add("# @timeout " + (long) Math.ceil(longestS));
    }
  }

  private static boolean near(Joints one, Joints other) {
    for (int i = 0; i < Joints.COUNT; i++) {
      if (Math.abs(one.get(i) - other.get(i)) > SAME_RAD) {
        return false;
      }
    }
    return true;
  }

  private void prepare() {
    for (SignalWrite each : facts.before()) {
      add(
          TestPieces.call(each),
          TestPieces.named(each, names.apply(each.name())) + ", as before the start");
    }
    if (!facts.tcpInFlange().equals(Pose.ZERO)) {
      add("set_tcp(" + TestPieces.pose(facts.tcpInFlange()) + ")", "as before the start");
    }
    if (facts.speedFraction() < 1) {
      add(
          "set_speed_slider(" + RunFrames.number(facts.speedFraction(), 4) + ")",
          "as before the start");
    }
    if (facts.steps().stream().anyMatch(RunStep.PopupShown.class::isInstance)) {
      add("hold_popups()", OperatorThread.start().replace("run ", "") + " closes them");
    }
  }

  private void answers() {
    for (RunStep each : facts.steps()) {
      if (each instanceof RunStep.Asked asked) {
        String question = "answer(" + TestPieces.piece(asked.text()) + ", ";
        asked
            .answer()
            .flatMap(TestPieces::of)
            .ifPresentOrElse(
                answer ->
                    add(
                        question
                            + answer
                            + ", after="
                            + RunFrames.seconds(asked.thoughtFrames())
                            + ")",
                        "asked at " + RunFrames.text(asked.frame())),
                () ->
                    lines.add(
                        "  # operator: what was answered is not known, put it here: "
                            + question
                            + "...), "
                            + asked.kind().expected()
                            + "; asked at "
                            + RunFrames.text(asked.frame())
                            + ": "
                            + TestPieces.quoted(asked.text())));
      }
    }
  }

  private void outputs() {
    int count = 0;
    for (RunStep each : facts.steps()) {
      if (each instanceof RunStep.Output change && count++ < MAX_OUTPUTS) {
        SignalWrite as = new SignalWrite.Digital(change.signal(), change.level());
        add(
            "eventually(" + TestPieces.condition(change) + within(change.frame() - reached) + ")",
            TestPieces.named(as, names.apply(as.name()))
                + (change.level() ? " on" : " off")
                + ", at "
                + RunFrames.text(change.frame()));
        reached = change.frame();
      }
    }
    if (count > MAX_OUTPUTS) {
      lines.add("  # " + (count - MAX_OUTPUTS) + " more changes of outputs are not looked at");
    }
  }

  private void end() {
    String within = "within=" + allowed(facts.end().frame() - reached) + ")";
    String at = "at " + RunFrames.text(facts.end().frame());
    switch (facts.end()) {
      case RunEnd.Finished(_, Optional<RunEnd.Place> place) -> {
        add("wait_for_end(" + within, at);
        place.ifPresentOrElse(
            this::place,
            () -> lines.add("  # the arm still moved then, so its place is not looked at"));
      }
      case RunEnd.Stopped _ -> {
        add("wait_for_end(" + within, "stopped, " + at);
        lines.add("  # the arm was stopped somewhere on its way, so its place is not looked at");
      }
      case RunEnd.Failed(_, String message) ->
          add("assert_program_fails(" + TestPieces.piece(message) + ", " + within, at);
      case RunEnd.Running _ -> goesOn();
      case RunEnd.Unsafe _ -> {
        goesOn();
        lines.add("  # the safety functions stopped the arm " + at + ", where this test ends");
      }
    }
  }

  /** As long as that is known, a little less. */
  private void goesOn() {
    double leftS = (facts.end().frame() - reached) * FrameTime.FRAME_S;
    if (leftS > ALWAYS_S) {
      double during = leftS * ALWAYS_SHARE - ALWAYS_S / 2;
      add("always(program_running(), during=" + RunFrames.number(during, 1) + ")", "it goes on");
    } else {
      add("assert_true(program_running())", "it goes on");
    }
  }

  private void place(RunEnd.Place place) {
    lines.add(
        "  # joints "
            + TestPieces.degrees(place.positionRad(), 1)
            + " degrees, TCP "
            + TestPieces.millimetres(
                place.tcpInBase().x(), place.tcpInBase().y(), place.tcpInBase().z()));
    add(
        "assert_joints_near(get_actual_joint_positions(), "
            + TestPieces.radians(place.positionRad())
            + ", deg="
            + END_DEG
            + ")");
  }

  private void add(String statement) {
    lines.add(line(statement, Optional.empty()));
  }

  private void add(String statement, String note) {
    lines.add(line(statement, Optional.of(note)));
  }
}
