package org.pendant.desktop.testwriter;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * Operator thread: what came from outside during a run, as a thread of a test: at the times at
 * which it came, or, where it answers the program, as long after that as it did then.
 */
final class OperatorThread {
  private static final String NAME = "operator";

  private final UnaryOperator<String> names;
  private final List<String> lines = new ArrayList<>();

  /** The frame of the run that what comes next would have its effect in. */
  private long frame;

  /** Whether a popup is on the screen that goes in the next frame. */
  private boolean closing;

  private OperatorThread(UnaryOperator<String> names) {
    this.names = names;
  }

  /** The lines of the thread; none where nothing came. */
  static List<String> lines(OperatedRun facts, UnaryOperator<String> names) {
    OperatorThread thread = new OperatorThread(names);
    facts.steps().forEach(thread::step);
    if (thread.lines.isEmpty()) {
      return List.of();
    }
    List<String> all = new ArrayList<>();
    all.add("# What people and clients did, at their times since the program started.");
    all.add("thread " + NAME + "():");
    all.addAll(thread.lines);
    all.add("end");
    return all;
  }

  /** The line that starts it. */
  static String start() {
    return "run " + NAME + "()";
  }

  private void step(RunStep step) {
    switch (step) {
      case RunStep.Input(long at, var write) ->
          at(at, TestPieces.call(write), TestPieces.named(write, names.apply(write.name())));
      case RunStep.Slider(long at, double fraction) ->
          at(at, "set_speed_slider(" + RunFrames.number(fraction, 4) + ")", "");
      case RunStep.Pause(long at, boolean byHand) -> {
        if (byHand) {
          at(at, "pause_program()", "");
        } else {
          await(at, "program_paused()", "the program pauses itself");
        }
      }
      case RunStep.Resume(long at) -> at(at, "resume_program()", "");
      case RunStep.Stop(long at) -> at(at, "stop_program()", "");
      case RunStep.PopupShown(long at, String text) ->
          await(at, "popup_open(" + TestPieces.piece(text) + ")", "");
      case RunStep.PopupClosed(long at, int older) -> close(at, older);
      case RunStep.Asked _, RunStep.Output _ -> {
        // the test itself has these
      }
    }
  }

  private void at(long wanted, String call, String what) {
    if (wanted > frame) {
      add("sleep(" + RunFrames.seconds(wanted - frame) + ")", "");
      frame = wanted;
      closing = false;
    }
    add(call, (what.isEmpty() ? "" : what + ", ") + "at " + RunFrames.text(wanted));
  }

  /** What the program does in a frame is seen after it, when the next one can be influenced. */
  private void await(long wanted, String condition, String what) {
    settle();
    String note = (what.isEmpty() ? "" : what + ", ") + "at " + RunFrames.text(wanted);
    add("eventually(" + condition + TestScript.within(wanted - frame) + ")", note);
    frame = Math.max(frame, wanted + 1);
  }

  private void close(long wanted, int older) {
    for (int i = 0; i <= older; i++) {
      settle();
      at(wanted, "close_popup()", i < older ? "one that came before" : "");
      closing = true;
    }
  }

  /** Has the popup go that was closed, before the next one is asked for. */
  private void settle() {
    if (closing) {
      add("sync()", "");
      frame++;
      closing = false;
    }
  }

  private void add(String statement, String note) {
    lines.add(TestScript.line(statement, Optional.of(note).filter(each -> !each.isEmpty())));
  }
}
