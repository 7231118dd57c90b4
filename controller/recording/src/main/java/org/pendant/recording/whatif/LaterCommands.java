package org.pendant.recording.whatif;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.InterpreterCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.eip.AssemblyCommand;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.message.Answer;
import org.pendant.controller.rtde.InputUpdate;
import org.pendant.controller.rtde.RtdeCommand;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.recording.replay.Journal;

/**
 * Later commands: what came from outside after the moment, for it to come again at the same robot
 * time: signals, clients, the world, the speed slider, lines for the interpreter. What people did
 * to the program itself, pauses and steps, does not come again. The other controllers of a cell
 * have their programs started again as well.
 */
final class LaterCommands {
  private final List<Journal.Noted> all;
  private final Variant variant;

  /** Starts the program in the frame after the moment; empty where it runs already. */
  private Optional<Journal.Noted> start;

  /** Whether it is another controller than that of the variant. */
  private final boolean neighbour;

  private final Map<Long, Answer> answers = new HashMap<>();
  private int next;

  LaterCommands(List<Journal.Noted> all, Variant variant, Optional<Journal.Noted> start) {
    this(all, variant, start, false);
  }

  private LaterCommands(
      List<Journal.Noted> all, Variant variant, Optional<Journal.Noted> start, boolean neighbour) {
    this.all = all;
    this.variant = variant;
    this.start = start;
    this.neighbour = neighbour;
    for (Journal.Noted each : all) {
      if (each.command() instanceof MessageCommand.AnswerQuestion(long number, Answer answer)) {
        answers.put(number, answer);
      }
    }
  }

  /** Those of a controller that goes on as it was beside that of the variant. */
  static LaterCommands ofNeighbour(List<Journal.Noted> all) {
    return new LaterCommands(all, Variant.asItWas(""), Optional.empty(), true);
  }

  /** What was answered to a question. */
  Optional<Answer> answer(long question) {
    return Optional.ofNullable(answers.get(question));
  }

  /** The commands of a frame, for each of which this is asked once, in the order of frames. */
  List<Command> of(long frame) {
    List<Command> now = new ArrayList<>();
    while (next < all.size() && all.get(next).frame() <= frame) {
      again(all.get(next).command()).ifPresent(now::add);
      next++;
    }
    return now;
  }

  /** Whether a program still has to be started. */
  boolean awaitsStart() {
    return start.isPresent();
  }

  private Optional<Command> again(Command command) {
    return switch (command) {
      case ProgramCommand program -> again(program);
      case BoxCommand.SetSpeedFraction slider ->
          Optional.<Command>of(slider).filter(each -> variant.speedFraction().isEmpty());
      case WorldCommand.AttachLoad load ->
          Optional.<Command>of(load).filter(each -> variant.loadKg().isEmpty());
      case RtdeCommand.WriteInputs(String writer, InputUpdate update) ->
          Optional.of(new RtdeCommand.WriteInputs(writer, slowed(update)));
      case IoCommand _,
          WorldCommand _,
          RtdeCommand _,
          AssemblyCommand _,
          InterpreterCommand _,
          SafetyCommand.SetSafetyInput _ ->
          Optional.of(command);
      default -> Optional.empty();
    };
  }

  private Optional<Command> again(ProgramCommand command) {
    if (start.isPresent() && start.get().command().equals(command)) {
      start = Optional.empty();
      return Optional.of(
          switch (command) {
            case ProgramCommand.StartProgram old ->
                new ProgramCommand.StartProgram(
                    variant.program().orElse(old.program()), old.folder());
            case ProgramCommand.ReplaceProgram old ->
                new ProgramCommand.ReplaceProgram(variant.program().orElse(old.program()));
            default -> command;
          });
    }
    boolean comes =
        command instanceof ProgramCommand.RunSecondary
            || command instanceof ProgramCommand.SetProgramsFolder
            || (neighbour && comesToNeighbour(command));
    return Optional.<Command>of(command).filter(each -> comes);
  }

  /** Programs start again; one that people stop goes on unless it has to give way to another. */
  private boolean comesToNeighbour(ProgramCommand command) {
    return starts(command)
        || (command instanceof ProgramCommand.StopProgram
            && all.subList(next, all.size()).stream().anyMatch(each -> starts(each.command())));
  }

  /** Whether a command starts a program. */
  static boolean starts(Command command) {
    return command instanceof ProgramCommand.StartProgram
        || command instanceof ProgramCommand.ReplaceProgram;
  }

  private InputUpdate slowed(InputUpdate update) {
    return variant.speedFraction().isEmpty()
        ? update
        : new InputUpdate(
            update.recipe(),
            update.writes(),
            variant.speedFraction(),
            update.externalWrench(),
            update.ignored());
  }
}
