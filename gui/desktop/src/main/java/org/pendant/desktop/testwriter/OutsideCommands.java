package org.pendant.desktop.testwriter;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.InterpreterCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.eip.AssemblyCommand;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.Answer;
import org.pendant.controller.rtde.RtdeCommand;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.recording.replay.Journal;
import org.pendant.script.debug.DebugRequest;

/**
 * Outside commands: what people and clients did during a run beyond what its snapshots show: the
 * answers that they gave, and what no test can repeat.
 */
final class OutsideCommands {
  private final Map<Long, Answer> answers = new HashMap<>();
  private final Set<Long> pauses = new HashSet<>();
  private final Set<String> shown = new HashSet<>();
  private final Set<Signal> outputs = new HashSet<>();
  private final Map<String, Long> left = new HashMap<>();
  private final boolean known;

  private OutsideCommands(boolean known) {
    this.known = known;
  }

  /** Those of a recording without a journal: nobody knows. */
  static OutsideCommands unknown() {
    return new OutsideCommands(false);
  }

  /**
   * Those of a run.
   *
   * @param first the frame in which it started
   * @param last its last frame
   */
  static OutsideCommands of(List<Journal.Noted> noted, long first, long last) {
    OutsideCommands all = new OutsideCommands(true);
    for (Journal.Noted each : noted) {
      if (each.frame() >= first && each.frame() <= last) {
        all.take(each.frame(), each.command());
      }
    }
    return all;
  }

  private void take(long frame, Command command) {
    switch (command) {
      case MessageCommand.AnswerQuestion(long number, Answer answer) -> answers.put(number, answer);
      case MessageCommand.ShowPopup show -> shown.add(show.text());
      case ProgramCommand.PauseProgram _ -> pauses.add(frame);
      case IoCommand.WriteSignals(String writer, var writes)
          when !writer.equals(InputOwners.BY_HAND) ->
          writes(frame, writes);
      case RtdeCommand.WriteInputs write -> {
        writes(frame, write.update().writes());
        if (write.update().externalWrench().isPresent()) {
          leave("an external force sensor was read", frame);
        }
      }
      case ProgramCommand.RunSecondary _ -> leave("a secondary program was run", frame);
      case ProgramCommand.AbortMove _ -> leave("a move was given up from outside", frame);
      case InterpreterCommand.Interpret _ -> leave("lines came for the interpreter", frame);
      case AssemblyCommand.ReceiveAssembly _ -> leave("data came by EtherNet/IP", frame);
      case WorldCommand.RunEncoder _ -> leave("a conveyor was driven", frame);
      case WorldCommand.AttachLoad _ -> leave("the load at the flange was changed", frame);
      case WorldCommand _ -> leave("the arm was pushed or pulled", frame);
      case SafetyCommand _ -> leave("power, brakes or safety inputs were switched", frame);
      case DebugCommand.Debug(var request) when request instanceof DebugRequest.Assign ->
          leave("a variable was changed in the debugger", frame);
      default -> {
        // seen in the snapshots, refused while a program runs, or without an effect on it
      }
    }
  }

  private void writes(long frame, List<SignalWrite> writes) {
    for (SignalWrite each : writes) {
      switch (each) {
        case SignalWrite.Digital(Signal signal, boolean _) when !each.input() ->
            outputs.add(signal);
        case SignalWrite.PortBit _, SignalWrite.PortRegister _ ->
            leave("a Modbus client wrote to the memory of the ports", frame);
        default -> {
          // inputs are seen in the snapshots
        }
      }
    }
  }

  private void leave(String what, long frame) {
    left.putIfAbsent(what, frame);
  }

  /** What was answered to a question. */
  Optional<Answer> answer(long question) {
    return Optional.ofNullable(answers.get(question));
  }

  /** Whether somebody paused the program in a frame, as far as that is known. */
  boolean paused(long frame) {
    return !known || pauses.contains(frame);
  }

  /** Whether a popup may have come from outside. */
  boolean showed(String popup) {
    return shown.contains(popup);
  }

  /** Outputs that were written from outside too, so that their changes are not the program's. */
  Set<Signal> outputs() {
    return outputs;
  }

  /**
   * What no test can repeat.
   *
   * @param first the frame in which the run started
   */
  List<String> left(long first) {
    List<String> words = new ArrayList<>();
    left.entrySet().stream()
        .sorted(
            Map.Entry.<String, Long>comparingByValue().thenComparing(Map.Entry.comparingByKey()))
        .forEach(
            each ->
                words.add(each.getKey() + " (at " + RunFrames.text(each.getValue() - first) + ")"));
    return words;
  }
}
