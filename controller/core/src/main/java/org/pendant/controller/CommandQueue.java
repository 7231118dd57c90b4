package org.pendant.controller;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.stream.Collectors;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.installation.InstallationProblem;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.Popup;
import org.pendant.controller.rtde.InputField;
import org.pendant.controller.rtde.InputRecipe;
import org.pendant.controller.rtde.InputUpdate;
import org.pendant.models.dynamics.Payload;
import org.pendant.script.debug.Debugger;
import org.pendant.script.function.ScriptPlace;
import org.pendant.script.variables.VariableTracer;
import org.pendant.script.vm.Interpreter;
import org.pendant.script.vm.Machine;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ScriptFailure;

/**
 * Command queue: takes commands from any thread and executes them in the frame loop. Secondary
 * programs run after the primary one in the frame.
 */
final class CommandQueue {
  /** Most commands between two frames; more are refused. */
  static final int CAPACITY = 1024;

  /** Most secondary programs in a frame; more are refused. */
  static final int MAX_SECONDARIES = 8;

  /** Most lines for interpreter mode that are checked in a frame; more wait for the next ones. */
  static final int MAX_LINES = 16;

  private static final Reply DONE = new Reply.Done();

  private final ControlBox box;
  private final Machine machine;
  private final Debugger debugger;
  private final ManualControl hand;
  private final VariableTracer tracer;
  private final InstallationHandler installed;
  private final BlockingQueue<PendingCommand> arrived = new ArrayBlockingQueue<>(CAPACITY);
  private final List<PendingCommand> secondaries = new ArrayList<>();
  private final Deque<PendingCommand> lines = new ArrayDeque<>();
  private final List<Answered> answered = new ArrayList<>();
  private int linesOfFrame;
  private ProgramsFolder folder;
  private CommandJournal journal = (frame, turn, command) -> {};
  private long frame;
  private long turn;

  private record Answered(PendingCommand command, Reply reply) {}

  CommandQueue(
      ControlBox box,
      Machine machine,
      Debugger debugger,
      ManualControl hand,
      VariableTracer tracer,
      InstallationHandler installed) {
    this.box = box;
    this.machine = machine;
    this.debugger = debugger;
    this.hand = hand;
    this.tracer = tracer;
    this.installed = installed;
    folder = box.programsFolder();
    debugger.noteIn(request -> journal.note(frame, turn, new Command.Debug(request)));
  }

  /** Has {@code journal} told of every command from now on. */
  void noteIn(CommandJournal journal) {
    this.journal = journal;
  }

  /** Any thread: leaves a command for the next frame. */
  PendingCommand post(Command command) {
    PendingCommand pending = new PendingCommand(command, arrived::remove);
    if (!arrived.offer(pending)) {
      pending
          .reply()
          .complete(
              new Reply.Refused("more than " + CAPACITY + " commands in a frame, try again later"));
    }
    return pending;
  }

  /**
   * Carries out what has arrived, in its order and at most {@link #CAPACITY} in a frame.
   *
   * @param afterEach runs after each command: the next one may end what this one has begun
   */
  void drain(Runnable afterEach) {
    turn = box.clock().frame() == frame ? turn + 1 : 0;
    frame = box.clock().frame();
    linesOfFrame = 0;
    interpretWaiting();
    for (int left = CAPACITY; left > 0; left--) {
      PendingCommand next = arrived.poll();
      if (next == null) {
        return;
      }
      if (!next.begin()) {
        continue;
      }
      if (!(next.command() instanceof Command.Debug)) {
        // what a debugger is asked it says itself
        journal.note(frame, turn, next.command());
      }
      if (next.command() instanceof Command.RunSecondary) {
        letWaitBeside(next);
      } else if (next.command() instanceof Command.Interpret && mustWait()) {
        letWait(next);
      } else {
        if (next.command() instanceof Command.ReplaceProgram && uploadRefusal().isEmpty()) {
          machine.stop();
          afterEach.run();
        }
        answered.add(new Answered(next, carryOut(next.command())));
        afterEach.run();
      }
    }
  }

  private void letWaitBeside(PendingCommand secondary) {
    if (secondaries.size() < MAX_SECONDARIES) {
      secondaries.add(secondary);
    } else {
      String why = "more than " + MAX_SECONDARIES + " secondary programs in a frame";
      answered.add(new Answered(secondary, new Reply.Refused(why)));
    }
  }

  /** Whether a line for interpreter mode cannot be checked yet, or others are before it. */
  private boolean mustWait() {
    return !lines.isEmpty() || !mayInterpret();
  }

  private boolean mayInterpret() {
    return linesOfFrame < MAX_LINES && !machine.interpreter().clearing();
  }

  private void letWait(PendingCommand line) {
    if (lines.size() < Interpreter.MAX_QUEUED) {
      lines.add(line);
    } else {
      answered.add(
          new Answered(
              line,
              new Reply.Interpreted(
                  new Interpreter.Response.Discarded(
                      "more than " + Interpreter.MAX_QUEUED + " statements are waiting"))));
    }
  }

  private void interpretWaiting() {
    while (!lines.isEmpty() && mayInterpret()) {
      PendingCommand next = lines.remove();
      answered.add(new Answered(next, carryOut(next.command())));
    }
  }

  /** Runs the secondary programs that have arrived. */
  void runSecondaries() {
    for (PendingCommand next : secondaries) {
      answered.add(new Answered(next, carryOut(next.command())));
    }
    secondaries.clear();
  }

  /** Refuses the secondary programs that have arrived. */
  void refuseSecondaries(String why) {
    for (PendingCommand next : secondaries) {
      answered.add(new Answered(next, new Reply.Refused(why)));
    }
    secondaries.clear();
  }

  /** Hands out the replies; the snapshot that shows the effect is published. */
  void reply() {
    if (answered.isEmpty()) {
      return;
    }
    List<Answered> ready = List.copyOf(answered);
    answered.clear();
    ready.forEach(each -> each.command().reply().complete(each.reply()));
  }

  private Reply carryOut(Command command) {
    try {
      return switch (command) {
        case Command.StartProgram start -> start(start);
        case Command.ReplaceProgram replace -> replace(replace.program());
        case Command.SetProgramsFolder set -> done(() -> folder = set.folder());
        case Command.ApplyInstallation apply -> granted(install(apply.installation()));
        case Command.ScannerLost lost -> done(() -> installed.scannerLost(lost.who()));
        case Command.StopProgram stop -> done(machine::stop);
        case Command.PauseProgram pause -> pause();
        case Command.ResumeProgram resume -> resume();
        case Command.RunSecondary secondary -> runSecondary(secondary);
        case Command.SetInput set -> done(() -> box.io().setInput(set.name(), set.level()));
        case Command.WriteSignals write -> granted(write(write.writer(), write.writes()));
        case Command.WriteInputs write -> granted(write(write.writer(), write.update()));
        case Command.ClaimInputs claim ->
            done(() -> claim.answer().accept(claim(claim.owner(), claim.recipe())));
        case Command.ClaimSignal claim ->
            granted(box.signals().owners().claim(claim.signal(), claim.owner()));
        case Command.ReleaseSignals release ->
            done(() -> box.signals().owners().release(release.owner()));
        case Command.ConfigureAssemblies made ->
            granted(box.links().assemblies().configure(made.pair()));
        case Command.ReceiveAssembly got ->
            granted(
                box.links().assemblies().received(got.instance(), got.data(), box.clock().timeS()));
        case Command.RunEncoder run ->
            done(() -> box.encoders().get(run.index()).run(run.ticksPerS()));
        case Command.SetSpeedFraction set -> granted(setSpeed(set.writer(), set.fraction()));
        case Command.AnswerPopup answer -> answer(answer.number());
        case Command.AnswerQuestion given ->
            done(() -> box.questions().answer(given.number(), given.answer()));
        case Command.CancelQuestion cancel -> done(() -> cancel(cancel.number()));
        case Command.Interpret line -> interpret(line);
        case Command.SkipInterpreted skip -> done(machine.interpreter()::skip);
        case Command.AskInterpreter ask ->
            new Reply.InterpreterState(machine.interpreter().status());
        case Command.ShutDown off -> done(box::shutDown);
        case Command.ShowPopup show ->
            done(
                () ->
                    box.popups()
                        .show(
                            box.clock().timeS(),
                            show.title(),
                            show.text(),
                            Popup.Severity.MESSAGE,
                            false));
        case Command.AbortMove abort ->
            machine.abortMove() ? DONE : new Reply.Refused("no move is under way");
        case Command.PowerOn on -> granted(box.safety().powerOn());
        case Command.PowerOff off -> powerOff();
        case Command.ReleaseBrakes release -> granted(box.safety().releaseBrakes());
        case Command.UnlockProtectiveStop unlock ->
            granted(box.safety().unlockProtectiveStop(unlock.early()));
        case Command.RestartSafety restart -> granted(box.safety().restartSafety());
        case Command.StartBackdrive start -> granted(box.safety().startBackdrive());
        case Command.EndBackdrive end -> granted(box.safety().endBackdrive());
        case Command.SetManualMode set -> done(() -> box.safety().setManualMode(set.manual()));
        case Command.SetSafetyInput set ->
            done(() -> box.safety().setInput(set.input(), set.active()));
        case Command.PushTool push -> done(() -> box.world().apply(push.wrenchAtTcpInBase()));
        case Command.PushLink push ->
            done(
                () ->
                    box.world().grip().push(push.link(), push.pointInLinkM(), push.forceInBaseN()));
        case Command.PullLink pull ->
            done(
                () ->
                    box.world().grip().pull(pull.link(), pull.pointInLinkM(), pull.placeInBaseM()));
        case Command.LetGo release -> done(box.world().grip()::letGo);
        case Command.StartFreedrive start -> granted(hand.guide(start.axes(), start.frame()));
        case Command.EndFreedrive end -> done(hand::endGuiding);
        case Command.AttachLoad attach -> done(() -> attach(attach.load()));
        case Command.Debug debug -> done(() -> debug.request().accept(debugger));
        case Command.Jog jog -> granted(hand.jog(jog.move(), jog.speedFraction()));
        case Command.TraceVariables trace -> done(() -> tracer.trace(trace.owner(), trace.paths()));
        case Command.StopJog stop -> done(hand::stop);
        case Command.SetTool set -> granted(hand.setTool(set.tool()));
        case Command.DeclarePayload declare ->
            granted(
                hand.declarePayload(
                    declare.massKg(), declare.cogInFlangeM(), declare.inertiaKgM2()));
        case Command.NoteLostTime lost -> done(() -> box.noteLostTime(lost.behindS()));
        case Command.WriteLog write -> done(() -> box.log().protocol(write.level(), write.text()));
      };
    } catch (IllegalArgumentException e) {
      return new Reply.Refused(e.getMessage());
    } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
      box.log().internalError(e);
      return new Reply.Refused("internal error: " + e);
    }
  }

  private static Reply done(Runnable action) {
    action.run();
    return DONE;
  }

  private static Reply granted(Optional<String> refusal) {
    return refusal.map(why -> (Reply) new Reply.Refused(why)).orElse(DONE);
  }

  /** Why a change of signals is refused; nothing has changed then. */
  private Optional<String> write(String writer, List<SignalWrite> writes) {
    boolean outputs =
        !writer.equals(InputOwners.BY_HAND) || machine.state() == ProgramState.STOPPED;
    for (SignalWrite write : writes) {
      Optional<String> refusal = box.signals().owners().refusal(write.name(), writer);
      if (refusal.isPresent()) {
        return refusal;
      }
      if (!write.input() && !outputs) {
        return Optional.of(
            write.name()
                + " belongs to program "
                + machine.programName()
                + ": outputs are set by hand only while none runs");
      }
    }
    writes.forEach(box.signals()::write);
    return Optional.empty();
  }

  /** Takes all inputs of a recipe, unless somebody else has some of them, which are answered. */
  private Set<String> claim(String owner, InputRecipe recipe) {
    InputOwners owners = box.signals().owners();
    Set<String> inUse =
        recipe.fields().stream()
            .filter(
                field -> !field.claims().stream().allMatch(each -> owners.mayWrite(each, owner)))
            .map(InputField::name)
            .collect(Collectors.toUnmodifiableSet());
    if (inUse.isEmpty()) {
      recipe.claims().forEach(each -> owners.claim(each, owner));
    }
    return inUse;
  }

  private Optional<String> write(String writer, InputUpdate update) {
    InputOwners owners = box.signals().owners();
    for (String claim : update.recipe().claims()) {
      if (!owners.mayWrite(claim, writer)) {
        return owners.refusal(claim, writer);
      }
    }
    update.writes().forEach(box.signals()::write);
    update.speedFraction().ifPresent(box.motion()::setSpeedFraction);
    update.externalWrench().ifPresent(box.flange().externalForceSensor()::read);
    box.links().inputWatchdogs().received(update.recipe().names(), box.clock().timeS());
    return Optional.empty();
  }

  private Optional<String> install(Installation next) {
    Optional<String> refusal = hand.settingRefusal("the installation is changed");
    if (refusal.isEmpty()) {
      refusal =
          InstallationCheck.refusal(next, box.armDescription()).map(InstallationProblem::toString);
    }
    if (refusal.isEmpty()) {
      installed.change(next);
    }
    return refusal;
  }

  private Reply powerOff() {
    machine.stop();
    return granted(box.safety().powerOff());
  }

  private void attach(Optional<Payload> load) {
    load.ifPresentOrElse(box.flange()::attachLoad, box.flange()::followDeclaredPayload);
  }

  private Reply interpret(Command.Interpret line) {
    linesOfFrame++;
    return new Reply.Interpreted(machine.interpreter().submit(line.line()));
  }

  private Reply start(Command.StartProgram start) {
    Optional<String> refusal = box.safety().programRefusal();
    if (refusal.isPresent()) {
      return new Reply.Refused(refusal.get());
    }
    if (machine.state() != ProgramState.STOPPED) {
      return new Reply.Refused("program " + machine.programName() + " runs already");
    }
    begin(start.program(), start.folder().orElse(folder));
    return DONE;
  }

  private void begin(Program program, ProgramsFolder files) {
    hand.giveUp();
    box.setProgramsFolder(files);
    box.programStarted();
    machine.start(program);
  }

  /** Why no program from outside may start now; empty if one may. */
  private Optional<String> uploadRefusal() {
    return box.isShutDown()
        ? Optional.of("the controller has been shut down")
        : box.safety().uploadRefusal();
  }

  /** The program before it has been stopped already, unless this one is refused. */
  private Reply replace(Program program) {
    Optional<String> refusal = uploadRefusal();
    if (refusal.isEmpty()) {
      begin(program, folder);
    }
    return granted(refusal);
  }

  private Optional<String> setSpeed(String writer, double fraction) {
    Optional<String> refusal = box.signals().owners().refusal(InputOwners.SPEED_SLIDER, writer);
    if (refusal.isEmpty()) {
      box.motion().setSpeedFraction(fraction);
    }
    return refusal;
  }

  private Reply pause() {
    if (machine.state() != ProgramState.RUNNING) {
      return new Reply.Refused("no program is running");
    }
    machine.pause();
    return DONE;
  }

  private Reply resume() {
    if (machine.state() != ProgramState.PAUSED && !machine.pausing()) {
      return new Reply.Refused("no program is paused");
    }
    Optional<String> refusal = box.safety().programRefusal();
    if (refusal.isPresent()) {
      return new Reply.Refused(refusal.get());
    }
    box.popups().closeBlocking();
    machine.resume();
    return DONE;
  }

  private Reply answer(long number) {
    boolean blocked = box.popups().blocked();
    if (!box.popups().answer(number)) {
      return new Reply.Refused("popup " + number + " is not open");
    }
    if (blocked && !box.popups().blocked() && box.safety().programRefusal().isEmpty()) {
      machine.resume();
    }
    return DONE;
  }

  private void cancel(long number) {
    box.questions().cancel(number);
    machine.stop();
  }

  private Reply runSecondary(Command.RunSecondary asked) {
    Program program = asked.program();
    Optional<String> refusal = uploadRefusal();
    if (refusal.isPresent()) {
      return new Reply.Refused(refusal.get());
    }
    ProgramsFolder ofPrimary = box.programsFolder();
    box.setProgramsFolder(asked.folder().orElse(folder));
    Optional<ScriptFailure> failure;
    try {
      failure = machine.runSecondary(program);
    } finally {
      box.setProgramsFolder(ofPrimary);
    }
    failure.ifPresent(
        why ->
            box.log()
                .error(
                    why.code(),
                    "secondary program "
                        + program.name()
                        + ", line "
                        + why.line()
                        + ": "
                        + why.message(),
                    new ScriptPlace(
                        program.source().name(), Debugger.MAIN, program.name(), why.line())));
    return failure.map(why -> (Reply) new Reply.Failed(why.message())).orElse(DONE);
  }
}
