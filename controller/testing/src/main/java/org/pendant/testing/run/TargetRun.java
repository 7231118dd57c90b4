package org.pendant.testing.run;

import static org.pendant.testing.run.TestRunTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import org.pendant.controller.Controller;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.bench.Choices;
import org.pendant.controller.bench.TestBench;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.message.Operator;
import org.pendant.language.source.Source;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.Program;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.remote.SentText;
import org.pendant.testing.remote.TargetEvent;
import org.pendant.testing.remote.TargetScript;
import org.pendant.testing.remote.TargetState;
import org.pendant.testing.remote.TargetTrouble;
import org.pendant.testing.remote.TargetView;
import org.pendant.testing.remote.TestTarget;
import org.pendant.testing.run.TestPlan.Chosen;

/**
 * Target run: one test of a target, from its first state to the end of the test. The test runs in a
 * controller here, which nothing else does, and which goes a step for each step of the target's
 * time that a state tells.
 */
final class TargetRun {
  /** Steps that are made up for at once, where states are far apart. */
  private static final int MAX_STEPS = 500;

  private final Chosen one;
  private final TestSettings settings;
  private final TestTarget target;
  private final TargetView view;
  private final BooleanSupplier cancelled;
  private final Controller controller;
  private final TestBench bench;
  private final Verdict verdict;
  private final Optional<SentRun> sent;
  private final TargetProgram program = new TargetProgram();
  private final TestOutput output = new TestOutput();
  private final long beganNs = System.nanoTime();
  private Optional<TestOutcome> trouble = Optional.empty();
  private double lastS = Double.NaN;
  private boolean abandoned;

  TargetRun(
      Chosen one,
      TestSettings settings,
      Builtins<ControlBox> builtins,
      TestTarget target,
      TargetView view,
      BooleanSupplier cancelled) {
    this.cancelled = cancelled;
    this.one = one;
    this.settings = settings;
    this.target = target;
    this.view = view;
    bench =
        new TestBench(
            one.test().number(),
            new Choices(List.of(), OptionalLong.of(settings.seed())),
            one.programs(),
            TreeMap<String, Value>::new);
    bench.runElsewhere();
    controller =
        new Controller(
            one.programs()
                .controller(one.test())
                .withSeed(settings.controller().seed())
                .withOperator(Operator.present()),
            builtins);
    controller.attach(bench);
    sent = one.test().watches() ? Optional.empty() : Optional.of(new SentRun(one, bench));
    verdict = new Verdict(one.file(), one.test(), one.programs(), bench);
  }

  /**
   * Gets the target ready for it.
   *
   * @throws TargetTrouble if it is not
   */
  void begin() throws TargetTrouble {
    view.clear();
    target.begin();
  }

  /**
   * Runs it, and leaves the target as it was.
   *
   * @throws TargetTrouble if the target is lost
   */
  TestResult run() throws TargetTrouble {
    TestOutcome outcome;
    try {
      begin(sent);
      outcome = untilItEnds();
    } catch (TargetTrouble | RuntimeException e) {
      var _ = end();
      throw e;
    }
    Optional<TargetTrouble> trouble = end();
    if (trouble.isEmpty()) {
      return result(outcome);
    }
    if (!outcome.status().red()) {
      throw trouble.get();
    }
    String why = text("notStoppable", trouble.get().getMessage());
    output.add(controller.state().timeS(), "target: " + why);
    return result(
        cancelled.getAsBoolean()
            ? verdict.error("interrupted", text("interruptedBut", why), 0)
            : outcome);
  }

  private void begin(Optional<SentRun> whole) throws TargetTrouble {
    if (whole.isEmpty()) {
      controller.startCompanion(one.file().program());
      return;
    }
    // its time is that of the target
    program.see(target.next());
    send(one.file().sent().source(), "", whole.get().test());
  }

  /** Leaves the target as it was; answers why that fails. */
  private Optional<TargetTrouble> end() {
    try {
      target.end();
      return Optional.empty();
    } catch (TargetTrouble e) {
      abandoned = true;
      return Optional.of(e);
    }
  }

  /** A red test, as its target is lost. */
  TestResult lost(TargetTrouble why) {
    String key = abandoned ? "lostWhileRunning" : "ofTarget";
    return result(verdict.error("target-lost", text(key, why.getMessage()), 0));
  }

  private TestOutcome untilItEnds() throws TargetTrouble {
    double timeoutS = one.test().timeoutS().orElse(settings.timeoutS());
    long mostFrames = FrameTime.framesFor(timeoutS);
    long wallNs = settings.wallTimeout().toNanos();
    while (true) {
      TargetState state = target.next();
      view.see(state);
      bench.changes().see(state.levels(), controller.state().timeS());
      program.see(state);
      view.see(target.variables());
      for (TargetEvent each : target.events()) {
        take(each);
      }
      for (int steps = steps(state.timeS()); steps > 0; steps--) {
        Optional<TestOutcome> outcome = step();
        if (outcome.isPresent()) {
          return outcome.get();
        }
      }
      if (cancelled.getAsBoolean()) {
        return verdict.error("interrupted", text("interruptedAtTarget"), 0);
      }
      if (controller.state().frame() >= mostFrames) {
        return verdict.late(0, text("ranLonger", timeoutS));
      }
      if (System.nanoTime() - beganNs > wallNs) {
        return verdict.late(0, text("tookLonger", wallNs / 1e9));
      }
    }
  }

  /** How many steps of this controller have gone by at the target; one where it does not say. */
  private int steps(double timeS) {
    double passedS = timeS - lastS;
    lastS = timeS;
    return passedS > 0 ? Math.clamp(Math.round(passedS / FrameTime.FRAME_S), 1, MAX_STEPS) : 1;
  }

  private void take(TargetEvent event) throws TargetTrouble {
    double timeS = controller.state().timeS();
    program.take(event);
    switch (event) {
      case TargetEvent.Said(var text) when sent.isPresent() && sent.get().takes(text) -> {}
      case TargetEvent.Said(var text) -> {
        view.addLine(text);
        output.add(timeS, text);
      }
      case TargetEvent.Noted(var text) -> {
        view.addLine(text);
        output.add(timeS, "target: " + text);
      }
      case TargetEvent.Failed failed -> output.add(timeS, "error: " + failed.text());
      case TargetEvent.PopupOpened(var number, var text) -> {
        output.add(timeS, "popup: " + text);
        view.popups().put(number, text);
        if (!bench.answers().popupsStay()) {
          carryOut(new MessageCommand.AnswerPopup(number));
        }
      }
      case TargetEvent.Asked(var text) ->
          trouble = Optional.of(verdict.error("no-answer", text("asksAtTarget", text), 0));
      case TargetEvent.Started _ -> view.programStarted();
      case TargetEvent.Ended _ -> {}
    }
  }

  private Optional<TestOutcome> step() throws TargetTrouble {
    Optional<Program> start = bench.takeStart();
    if (start.isPresent()) {
      start(start.get());
    }
    for (Command each : bench.takeCommands()) {
      carryOut(each);
    }
    if (program.overdue()) {
      trouble = Optional.of(verdict.error("not-started", text("notStarted"), 0));
    }
    if (trouble.isPresent()) {
      return trouble;
    }
    bench.seeElsewhere(program.state(), program.ending());
    controller.advance();
    output.take(controller.state());
    Optional<Ending> ending =
        sent.isPresent() ? sent.get().ending(program, view) : controller.companionEnding();
    return ending.map(this::outcome);
  }

  private void start(Program wanted) throws TargetTrouble {
    Optional<TargetScript> script = TargetScript.of(wanted.source());
    if (script.isEmpty()) {
      trouble =
          Optional.of(verdict.error("no-program", text("secondary", wanted.source().name()), 0));
      return;
    }
    send(wanted.source(), wanted.name(), script.get());
  }

  private void send(Source source, String function, SentText text) throws TargetTrouble {
    program.sent(source, function, text);
    view.programSent();
    target.start(text.text());
  }

  private void carryOut(Command command) throws TargetTrouble {
    if (command instanceof ProgramCommand.StopProgram) {
      program.stopAsked();
    }
    if (command instanceof MessageCommand.AnswerPopup(var number)) {
      view.popups().remove(number);
    }
    Optional<String> refusal = target.carryOut(command);
    if (refusal.isPresent() && trouble.isEmpty()) {
      trouble = Optional.of(verdict.error("refused", text("ofTarget", refusal.get()), 0));
    }
  }

  private TestOutcome outcome(Ending ending) {
    TestOutcome outcome = verdict.of(ending, controller.state());
    return outcome.status() == TestStatus.PASSED
            && view.stopped()
            && !bench.expected().knowsSafetyStop()
        ? verdict.error("safety-stop", text("safetyStop", view.safetyMode()), 0)
        : outcome;
  }

  private TestResult result(TestOutcome outcome) {
    return new TestResult(
        one.test().id(),
        one.test().place(),
        one.test().tags(),
        outcome.status(),
        outcome.skipped(),
        outcome.failure(),
        controller.state().timeS(),
        (System.nanoTime() - beganNs) * 1e-9,
        output.lines());
  }
}
