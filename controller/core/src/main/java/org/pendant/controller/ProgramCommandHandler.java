package org.pendant.controller;

import static org.pendant.controller.ControllerTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Refusal.Code;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.script.debug.Debugger;
import org.pendant.script.function.ScriptPlace;
import org.pendant.script.vm.Machine;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ScriptFailure;

/**
 * Handler of the commands about programs: starts, stops, pauses and resumes programs, and runs
 * secondary ones.
 */
final class ProgramCommandHandler implements CommandHandler<ProgramCommand> {
  private final ControlBox box;
  private final Machine machine;
  private final ManualControl hand;
  private ProgramsFolder folder;

  ProgramCommandHandler(ControlBox box, Machine machine, ManualControl hand) {
    this.box = box;
    this.machine = machine;
    this.hand = hand;
    folder = box.environment().programsFolder();
  }

  @Override
  public Class<ProgramCommand> family() {
    return ProgramCommand.class;
  }

  @Override
  public Reply carryOut(ProgramCommand command) {
    return switch (command) {
      case ProgramCommand.StartProgram start -> start(start);
      case ProgramCommand.ReplaceProgram(Program program) -> replace(program);
      case ProgramCommand.SetProgramsFolder set -> {
        folder = set.folder();
        yield Reply.done();
      }
      case ProgramCommand.StopProgram _ -> {
        machine.stop();
        yield Reply.done();
      }
      case ProgramCommand.PauseProgram _ -> pause();
      case ProgramCommand.ResumeProgram _ -> resume();
      case ProgramCommand.RunSecondary secondary -> runSecondary(secondary);
      case ProgramCommand.AbortMove _ ->
          machine.abortMove() ? Reply.done() : new Reply.Refused(Code.PROGRAM, text("noMove"));
    };
  }

  private Reply start(ProgramCommand.StartProgram start) {
    Optional<Refusal> refusal = box.safety().programRefusal();
    if (refusal.isPresent()) {
      return new Reply.Refused(refusal.get());
    }
    if (machine.state() != ProgramState.STOPPED) {
      return new Reply.Refused(Code.PROGRAM, text("programRunsAlready", machine.programName()));
    }
    begin(start.program(), start.folder().orElse(folder));
    return Reply.done();
  }

  private void begin(Program program, ProgramsFolder files) {
    hand.giveUp();
    box.environment().setProgramsFolder(files);
    box.programStarted();
    machine.start(program);
  }

  /** Why no program from outside may start now; empty if one may. */
  private Optional<Refusal> uploadRefusal() {
    return box.safety().isShutDown()
        ? Optional.of(new Refusal(Code.SWITCHED_OFF, text("shutDown")))
        : box.safety().uploadRefusal();
  }

  /** Ends the program that another one from outside replaces, unless that one is refused. */
  boolean makeRoom() {
    boolean allowed = uploadRefusal().isEmpty();
    if (allowed) {
      machine.stop();
    }
    return allowed;
  }

  /** The program before it has been stopped by {@link #makeRoom}, unless this one is refused. */
  private Reply replace(Program program) {
    Optional<Refusal> refusal = uploadRefusal();
    if (refusal.isEmpty()) {
      begin(program, folder);
    }
    return Reply.unless(refusal);
  }

  private Reply pause() {
    if (machine.state() != ProgramState.RUNNING) {
      return new Reply.Refused(Code.PROGRAM, text("noneRunning"));
    }
    machine.pause();
    return Reply.done();
  }

  private Reply resume() {
    if (machine.state() != ProgramState.PAUSED && !machine.pausing()) {
      return new Reply.Refused(Code.PROGRAM, text("nonePaused"));
    }
    Optional<Refusal> refusal = box.safety().programRefusal();
    if (refusal.isPresent()) {
      return new Reply.Refused(refusal.get());
    }
    box.prompts().popups().closeBlocking();
    machine.resume();
    return Reply.done();
  }

  private Reply runSecondary(ProgramCommand.RunSecondary asked) {
    Program program = asked.program();
    Optional<Refusal> refusal = uploadRefusal();
    if (refusal.isPresent()) {
      return new Reply.Refused(refusal.get());
    }
    ProgramsFolder ofPrimary = box.environment().programsFolder();
    box.environment().setProgramsFolder(asked.folder().orElse(folder));
    Optional<ScriptFailure> failure;
    try {
      failure = machine.runSecondary(program);
    } finally {
      box.environment().setProgramsFolder(ofPrimary);
    }
    failure.ifPresent(why -> report(program, why));
    return failure.map(why -> (Reply) new Reply.Failed(why)).orElse(Reply.done());
  }

  private void report(Program program, ScriptFailure why) {
    box.log()
        .error(
            why.code(),
            text("secondaryLine", program.name(), why.line(), why.message()),
            new ScriptPlace(program.source().name(), Debugger.MAIN, program.name(), why.line()));
  }
}
