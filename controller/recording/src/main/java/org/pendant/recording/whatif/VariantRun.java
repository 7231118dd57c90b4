package org.pendant.recording.whatif;

import static org.pendant.recording.whatif.VariantTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.Controller;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.replay.Controllers;
import org.pendant.recording.replay.Journal;
import org.pendant.recording.replay.ParkedRuns;
import org.pendant.recording.replay.Repetition;
import org.pendant.recording.replay.Rerun;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.script.debug.DebugRequest;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ProgramState;

/**
 * Variant run: one variant, from a moment of a run to the end of its program, as fast as the
 * processor goes and in a controller of its own, which reaches nothing outside. The controller
 * whose run it was is not touched and may continue meanwhile. In a cell the variant is that of one
 * of the controllers; the others go on as they did.
 *
 * <p>What came from outside after the moment comes again at the same robot time, and breakpoints
 * and pauses do not. Popups are closed at once, questions get the answers that they got.
 *
 * <p>One thread runs it, once; any thread may ask how far it is, or cancel it.
 */
public final class VariantRun {
  private final Journal journal;
  private final ParkedRuns parked;
  private final int member;
  private final Variant variant;
  private final VariantLimits limits;
  private final Rerun rerun;

  /** The command that starts the program after the moment; empty where it runs then. */
  private final Optional<Journal.Noted> start;

  private final List<CompletableFuture<Reply>> wishes = new ArrayList<>();
  private volatile boolean cancelled;
  private volatile double reachedS;
  private OptionalLong startedFrame = OptionalLong.empty();

  private VariantRun(
      ParkedRuns parked, int member, Variant variant, VariantLimits limits, OptionalLong moment)
      throws RerunRefused {
    this.parked = parked;
    this.member = member;
    journal = parked.journal().of(member);
    this.variant = variant;
    this.limits = limits;
    long frame = moment.orElse(journal.controller().state().frame());
    Journal.Noted started =
        journal.programStart(frame).orElseThrow(() -> new RerunRefused(text("noProgramYet")));
    boolean anew = moment.isEmpty() || variant.program().isPresent();
    start = anew ? Optional.of(started) : Optional.empty();
    rerun = Rerun.to(anew ? Math.max(0, started.frame() - 1) : frame, parked.journal());
  }

  /**
   * A run from a moment on. A variant with another program goes from the start of the program that
   * ran at that moment, as there is no middle of a program that never ran.
   *
   * @param frame at whose end it begins
   * @param parked of the run
   * @param member number of the controller that the variant is of
   * @throws RerunRefused if no program was started before, or the run cannot be repeated so far
   */
  public static VariantRun from(
      long frame, ParkedRuns parked, int member, Variant variant, VariantLimits limits)
      throws RerunRefused {
    return new VariantRun(parked, member, variant, limits, OptionalLong.of(frame));
  }

  /** As {@link #from}, from the start of the program that was started last. */
  public static VariantRun fromStart(
      ParkedRuns parked, int member, Variant variant, VariantLimits limits) throws RerunRefused {
    return new VariantRun(parked, member, variant, limits, OptionalLong.empty());
  }

  /** What it is a run of. */
  public Variant variant() {
    return variant;
  }

  /** Whether it goes from the start of the program, and not from a moment in it. */
  public boolean fromStart() {
    return start.isPresent();
  }

  /** How much of the way to the moment is repeated, 0 to 1. */
  public double repeated() {
    return rerun.progress();
  }

  /** How much robot time has gone by since the moment, s. */
  public double reachedS() {
    return reachedS;
  }

  /** Has {@link #run} end as soon as possible. */
  public void cancel() {
    cancelled = true;
    rerun.cancel();
  }

  /**
   * Runs it.
   *
   * @throws RerunRefused if the run came out otherwise before the moment, or no program ran then
   * @throws CancellationException after {@link #cancel}
   */
  public VariantOutcome run() throws RerunRefused {
    Repetition repetition = parked.before(rerun.frame());
    rerun.run(repetition);
    startedFrame = repetition.startedFrame(member);
    Controllers all = repetition.controllers();
    Controller fresh = all.all().get(member);
    ControllerState moment = fresh.state();
    if (start.isEmpty() && moment.program().state() == ProgramState.STOPPED) {
      throw new RerunRefused(text("noProgramThen"));
    }
    List<LaterCommands> later = later(all.all().size());
    VariantMeasure measure = new VariantMeasure(moment, fresh.safety());
    NeighbourWatch neighbours = new NeighbourWatch(all, member);
    vary(fresh, moment);
    all.all().forEach(VariantRun::leaveDebugger);
    long stopNs = System.nanoTime() + limits.wallTime().toNanos();
    double mostS = limits.robotTime().toNanos() / 1e9;
    while (measure.timeS() < mostS && System.nanoTime() < stopNs) {
      if (cancelled) {
        throw new CancellationException(text("variantCancelled"));
      }
      step(all, later);
      ControllerState state = fresh.state();
      noteStart(state);
      measure.see(state);
      neighbours.see();
      reachedS = measure.timeS();
      Optional<VariantOutcome> ended = ended(state, later.get(member), measure);
      if (ended.isPresent()) {
        return ended.get();
      }
    }
    Rounds.Round round = measure.round();
    return outcome(
        VariantOutcome.End.LIMIT,
        runsOn(measure.timeS(), neighbours.trouble()),
        round.line() == 0
            ? OptionalDouble.empty()
            : OptionalDouble.of(round.frames() * FrameTime.FRAME_S),
        round.line(),
        measure);
  }

  private static String runsOn(double timeS, Optional<String> trouble) {
    String seconds = String.format(Locale.ROOT, "%.0f", timeS);
    return trouble
        .map(why -> text("runsOnWithTrouble", seconds, why))
        .orElseGet(() -> text("runsOn", seconds));
  }

  private void noteStart(ControllerState state) {
    for (ProgramEvent each : state.newProgramEvents()) {
      if (each instanceof ProgramEvent.Started) {
        startedFrame = OptionalLong.of(state.frame());
      }
    }
  }

  /** What came to each of {@code count} controllers after the moment. */
  private List<LaterCommands> later(int count) {
    List<LaterCommands> later = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      List<Journal.Noted> noted = parked.journal().of(i).after(rerun.frame());
      later.add(
          i == member
              ? new LaterCommands(noted, variant, start)
              : LaterCommands.ofNeighbour(noted));
    }
    return later;
  }

  /** Leaves what makes the variant. */
  private void vary(Controller fresh, ControllerState moment) {
    variant
        .speedFraction()
        .ifPresent(share -> wishes.add(fresh.submit(new BoxCommand.SetSpeedFraction(share))));
    variant
        .loadKg()
        .ifPresent(
            kg ->
                wishes.add(
                    fresh.submit(
                        new WorldCommand.AttachLoad(
                            Optional.of(load(kg, moment.readings().payload()))))));
  }

  /** Has no debugger pause a program, and one continue that people had paused. */
  private static void leaveDebugger(Controller fresh) {
    var _ = fresh.submit(new DebugCommand.Debug(new DebugRequest.RemoveBreakpoints()));
    var _ = fresh.submit(new DebugCommand.Debug(new DebugRequest.StopOnErrors(false)));
    if (fresh.held()) {
      var _ = fresh.submit(new DebugCommand.Debug(new DebugRequest.Resume()));
    }
  }

  private static Payload load(double kg, Payload declared) {
    return Payload.of(kg, declared.cogXM(), declared.cogYM(), declared.cogZM());
  }

  private void step(Controllers all, List<LaterCommands> later) {
    for (int i = 0; i < later.size(); i++) {
      goOn(all.all().get(i), later.get(i));
    }
    if (all.frames().held()) {
      all.frames().applyCommands();
      return;
    }
    for (int i = 0; i < later.size(); i++) {
      repeat(all.all().get(i), later.get(i));
    }
    all.frames().advance();
  }

  /** Nobody waits for people: they have said already what they had to say. */
  private static void goOn(Controller fresh, LaterCommands later) {
    ControllerState before = fresh.state();
    for (Popup each : before.openPopups()) {
      var _ = fresh.submit(new MessageCommand.AnswerPopup(each.number()));
    }
    for (Question each : before.openQuestions()) {
      Optional<Answer> answer = later.answer(each.number());
      answer.ifPresent(
          said -> {
            var _ = fresh.submit(new MessageCommand.AnswerQuestion(each.number(), said));
          });
    }
    if (before.program().state() == ProgramState.PAUSED) {
      var _ = fresh.submit(new ProgramCommand.ResumeProgram());
    }
  }

  /** Leaves what came in the next frame. */
  private void repeat(Controller fresh, LaterCommands later) {
    boolean awaited = later.awaitsStart();
    for (Command each : later.of(fresh.state().frame() + 1)) {
      CompletableFuture<Reply> reply = fresh.submit(each);
      if (awaited && !later.awaitsStart() && LaterCommands.starts(each)) {
        wishes.add(reply);
      }
    }
  }

  private Optional<VariantOutcome> ended(
      ControllerState state, LaterCommands later, VariantMeasure measure) {
    Optional<String> complaint = complaint();
    if (complaint.isPresent()) {
      return Optional.of(
          outcome(VariantOutcome.End.REFUSED, complaint.get(), OptionalDouble.empty(), 0, measure));
    }
    if (later.awaitsStart()) {
      return Optional.empty();
    }
    Optional<SafetyStop> stop = state.safety().stop();
    for (ProgramEvent each : state.newProgramEvents()) {
      if (each instanceof ProgramEvent.Ended ended && startedFrame.isPresent()) {
        return Optional.of(ended(ended.ending(), stop, measure, state.frame()));
      }
    }
    if (stop.isPresent() && state.program().state() == ProgramState.PAUSED) {
      return Optional.of(
          outcome(
              VariantOutcome.End.STOPPED,
              stop.get().message(),
              OptionalDouble.empty(),
              0,
              measure));
    }
    return state.openQuestions().stream()
        .filter(question -> later.answer(question.number()).isEmpty())
        .findFirst()
        .map(
            question ->
                outcome(
                    VariantOutcome.End.QUESTION,
                    text("asks", question.text()),
                    OptionalDouble.empty(),
                    0,
                    measure));
  }

  private Optional<String> complaint() {
    return wishes.stream()
        .filter(CompletableFuture::isDone)
        .flatMap(each -> each.join().complaint().stream())
        .findFirst();
  }

  private VariantOutcome ended(
      Ending ending, Optional<SafetyStop> stop, VariantMeasure measure, long frame) {
    OptionalDouble cycleS =
        OptionalDouble.of((frame - startedFrame.orElse(frame)) * FrameTime.FRAME_S);
    return switch (ending) {
      case Ending.Finished _ ->
          outcome(VariantOutcome.End.FINISHED, text("finished"), cycleS, 0, measure);
      case Ending.Halted _ ->
          outcome(VariantOutcome.End.FINISHED, text("halted"), cycleS, 0, measure);
      case Ending.Failed(var failure) ->
          outcome(
              VariantOutcome.End.FAILED,
              text("failedInLine", failure.line(), failure.message()),
              OptionalDouble.empty(),
              0,
              measure);
      case Ending.Stopped _ ->
          outcome(
              VariantOutcome.End.STOPPED,
              stop.map(SafetyStop::message).orElseGet(() -> text("stopped")),
              OptionalDouble.empty(),
              0,
              measure);
    };
  }

  private VariantOutcome outcome(
      VariantOutcome.End end,
      String words,
      OptionalDouble cycleS,
      int roundOf,
      VariantMeasure measure) {
    return new VariantOutcome(
        variant,
        end,
        words,
        measure.timeS(),
        cycleS,
        roundOf,
        measure.torque(),
        measure.jointSpeed(),
        measure.energyJ(),
        measure.way(),
        measure.track());
  }
}
