package org.pendant.desktop.testwriter;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingMark;
import org.pendant.recording.replay.Journal;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ProgramState;

/**
 * Run reader: reads from a recording what a test of the last run is written from. It goes through
 * all frames of the run, so it is not for the dispatch thread.
 */
public final class RunReader {
  /** A signal that changes more often is not an operator's, and nobody would read the test. */
  private static final int MAX_CHANGES = 100;

  private static final Pattern OUTSIDE = Pattern.compile("\\b(socket_open|rpc_factory)\\s*\\(");
  private static final double REST_RAD_PER_S = 1e-3;

  private final long first;
  private final OutsideCommands commands;
  private final List<RunStep> steps = new ArrayList<>();
  private final Map<String, Integer> changes = new HashMap<>();
  private final List<Popup> popups = new ArrayList<>();
  private final Map<Long, Integer> questions = new HashMap<>();
  private final Set<String> left = new HashSet<>();
  private ControllerState before;
  private Optional<RunEnd> end = Optional.empty();
  private boolean paused;

  private RunReader(ControllerState before, long first, OutsideCommands commands) {
    this.before = before;
    this.first = first;
    this.commands = commands;
  }

  /**
   * The last run of a recording; empty where its start is not in it.
   *
   * @param journal commands of the controller that was recorded, those of the run at least; empty
   *     where they are not known
   */
  public static Optional<OperatedRun> read(
      Recording recording, Optional<List<Journal.Noted>> journal) {
    return recording.marks().reversed().stream()
        .filter(mark -> mark.kind() == RecordingMark.Kind.PROGRAM_STARTED)
        .findFirst()
        .map(start -> read(recording, start.frame(), journal));
  }

  private static OperatedRun read(
      Recording recording, long first, Optional<List<Journal.Noted>> journal) {
    OutsideCommands commands =
        journal
            .map(noted -> OutsideCommands.of(noted, first, lastFrame(recording, first)))
            .orElseGet(OutsideCommands::unknown);
    ControllerState before = recording.atFrame(first - 1);
    RunReader reader = new RunReader(before, first, commands);
    if (recording
        .programOf(first)
        .filter(each -> OUTSIDE.matcher(each.source().text()).find())
        .isPresent()) {
      reader.left.add(
          "the program speaks to other computers, which listen(...) and rpc_answer(...) play");
    }
    recording.frames(first, recording.lastFrame(), reader::see);
    return reader.facts(before, recording.lastFrame() - first);
  }

  private static long lastFrame(Recording recording, long first) {
    return recording.marks().stream()
        .filter(
            mark ->
                mark.kind() == RecordingMark.Kind.PROGRAM_ENDED
                    || mark.kind() == RecordingMark.Kind.PROGRAM_FAILED)
        .mapToLong(RecordingMark::frame)
        .filter(frame -> frame >= first && hasEnded(recording.atFrame(frame)))
        .findFirst()
        .orElse(recording.lastFrame());
  }

  /** Also secondary programs fail, which ends nothing. */
  private static boolean hasEnded(ControllerState state) {
    return state.program().state() == ProgramState.STOPPED;
  }

  private OperatedRun facts(ControllerState start, long lastFrame) {
    RunEnd ended = end.orElseGet(() -> new RunEnd.Running(lastFrame));
    changes.forEach(
        (signal, count) -> {
          if (count > MAX_CHANGES) {
            left.add(signal + " was changed " + count + " times");
          }
        });
    steps.removeIf(
        step ->
            step instanceof RunStep.Input(long _, SignalWrite write)
                && changes.get(write.name()) > MAX_CHANGES);
    List<String> words = new ArrayList<>(commands.left(first));
    left.stream().sorted().forEach(words::add);
    return new OperatedRun(
        start.arm().targetPositionRad(),
        start.arm().tool().inFlange(),
        start.arm().speedFraction(),
        OutsideSignals.set(start),
        steps,
        ended,
        words);
  }

  private void see(ControllerState now) {
    if (end.isPresent()) {
      return;
    }
    long frame = now.frame() - first;
    for (SignalWrite each : OutsideSignals.changed(before, now)) {
      if (changes.merge(each.name(), 1, Integer::sum) <= MAX_CHANGES) {
        steps.add(new RunStep.Input(frame, each));
      }
    }
    if (now.arm().speedFraction() != before.arm().speedFraction()) {
      steps.add(new RunStep.Slider(frame, now.arm().speedFraction()));
    }
    for (Signal each : OutsideSignals.changedOutputs(before, now)) {
      if (commands.outputs().contains(each)) {
        left.add(each + " was written from outside, so that its changes are not expected");
      } else {
        steps.add(new RunStep.Output(frame, each, now.io().level(each)));
      }
    }
    asked(now, frame);
    popups(now, frame);
    pauses(now, frame);
    if (now.freedrive()
        .mode()
        .filter(each -> each.holder() != FreedriveHolder.PROGRAM)
        .isPresent()) {
      left.add("the arm was guided by hand");
    }
    if (!now.modbus().isEmpty()) {
      left.add("the program has signals at Modbus devices, which modbus_device(...) plays");
    }
    end = ended(now, frame);
    before = now;
  }

  private void asked(ControllerState now, long frame) {
    for (Question each : now.newQuestions()) {
      questions.put(each.number(), steps.size());
      steps.add(
          new RunStep.Asked(frame, each.text(), each.kind(), commands.answer(each.number()), 0));
    }
    Set<Long> open = new HashSet<>();
    now.openQuestions().forEach(each -> open.add(each.number()));
    questions
        .entrySet()
        .removeIf(
            each -> {
              if (open.contains(each.getKey())) {
                return false;
              }
              RunStep.Asked asked = (RunStep.Asked) steps.get(each.getValue());
              steps.set(
                  each.getValue(),
                  new RunStep.Asked(
                      asked.frame(),
                      asked.text(),
                      asked.kind(),
                      asked.answer(),
                      Math.max(1, frame - asked.frame())));
              return true;
            });
  }

  private void popups(ControllerState now, long frame) {
    for (Popup each : now.newPopups()) {
      if (each.blocking() || !commands.showed(each.text())) {
        popups.add(each);
        if (each.blocking()) {
          steps.add(new RunStep.PopupShown(frame, each.text()));
        }
      }
    }
    if (stopped(now)) {
      // that has closed them
      return;
    }
    for (int i = 0; i < popups.size(); i++) {
      Popup each = popups.get(i);
      if (each.blocking() && !now.openPopups().contains(each)) {
        steps.add(new RunStep.PopupClosed(frame, i));
        popups.subList(0, i + 1).clear();
        i = -1;
      }
    }
  }

  private static boolean stopped(ControllerState state) {
    return state.program().ending().filter(Ending.Stopped.class::isInstance).isPresent();
  }

  private static boolean blocked(ControllerState state) {
    return state.openPopups().stream().anyMatch(Popup::blocking)
        || state.safety().stop().isPresent()
        || state.debug().held();
  }

  private void pauses(ControllerState now, long frame) {
    if (blocked(now) || blocked(before)) {
      return;
    }
    boolean stands = now.program().state() == ProgramState.PAUSED;
    if (stands && !paused) {
      steps.add(new RunStep.Pause(frame, commands.paused(now.frame())));
      paused = true;
    } else if (!stands && paused) {
      if (!stopped(now)) {
        steps.add(new RunStep.Resume(frame));
      }
      paused = false;
    }
  }

  private Optional<RunEnd> ended(ControllerState now, long frame) {
    Optional<SafetyStop> stop = now.safety().stop();
    if (stop.isPresent()) {
      return Optional.of(new RunEnd.Unsafe(frame, stop.get().message()));
    }
    for (ProgramEvent each : now.newProgramEvents()) {
      if (each instanceof ProgramEvent.Ended ended) {
        return Optional.of(ended(ended.ending(), now, frame));
      }
    }
    return Optional.empty();
  }

  private RunEnd ended(Ending ending, ControllerState now, long frame) {
    return switch (ending) {
      case Ending.Finished _, Ending.Halted _ -> new RunEnd.Finished(frame, place(now));
      case Ending.Failed(var failure) -> new RunEnd.Failed(frame, failure.message());
      case Ending.Stopped _ -> {
        steps.add(new RunStep.Stop(frame));
        yield new RunEnd.Stopped(frame);
      }
    };
  }

  private static Optional<RunEnd.Place> place(ControllerState now) {
    Joints speed = now.arm().targetSpeedRadPerS();
    for (int i = 0; i < Joints.COUNT; i++) {
      if (Math.abs(speed.get(i)) > REST_RAD_PER_S) {
        return Optional.empty();
      }
    }
    return Optional.of(
        new RunEnd.Place(now.arm().targetPositionRad(), now.arm().targetTcpInBase()));
  }
}
