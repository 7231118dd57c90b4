package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import java.util.Optional;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.bench.TestBench;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Ending;

/** The program under test: started, paused and stopped as a whole, and how it ended. */
final class ProgramBuiltins {
  private static final String SECTION = "The program under test";
  private static final Optional<Value> DONE = Optional.of(NoneValue.NONE);
  private static final double USUAL_S = 60;

  private ProgramBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "start", SECTION)
        .doc(
            "Starts a program as the play button does, .script, .pendant or .urp; the test"
                + " continues beside it. Its name counts from the folder of the test.")
        .needs("file", Type.STRING)
        .does(
            call -> {
              TestBuiltins.bench(call).start(call.text(0));
              return call.answer();
            });
    control(builtins, "stop_program", "Ends the program under test, as the stop button does.")
        .does(call -> post(call, new ProgramCommand.StopProgram()));
    control(builtins, "pause_program", "Pauses the program under test, as the pause button does.")
        .does(call -> post(call, new ProgramCommand.PauseProgram()));
    control(builtins, "resume_program", "Has the program under test continue after a pause.")
        .does(call -> post(call, new ProgramCommand.ResumeProgram()));
    TestBuiltins.declare(builtins, "program_running", SECTION)
        .doc("Whether the program under test runs or is paused.")
        .returns(Type.BOOL)
        .effect(Effect.SENSES)
        .does(call -> call.answer(TestBuiltins.bench(call).running()));
    TestBuiltins.declare(builtins, "program_paused", SECTION)
        .doc("Whether the program under test is paused.")
        .returns(Type.BOOL)
        .effect(Effect.SENSES)
        .does(call -> call.answer(TestBuiltins.bench(call).paused()));
    TestBuiltins.declare(builtins, "program_variable", SECTION)
        .doc("What a global variable of the program under test is.")
        .needs("name", Type.STRING)
        .returns(Type.ANY)
        .effect(Effect.SENSES)
        .does(ProgramBuiltins::variable);
    declareEndings(builtins);
  }

  private static Declaration<ControlBox> control(
      Builtins<ControlBox> builtins, String name, String what) {
    return TestBuiltins.declare(builtins, name, SECTION).doc(what);
  }

  private static void declareEndings(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "wait_for_end", SECTION)
        .doc(
            "Waits until the program under test has ended without an error; fails the test if it"
                + " ends with one, or not within some time.")
        .takes("within", Unit.SECOND, USUAL_S)
        .physicalTime()
        .does(call -> awaitEnd(call, Optional.empty()));
    TestBuiltins.declare(builtins, "assert_program_fails", SECTION)
        .doc(
            "Waits until the program under test has ended with an error whose message contains this"
                + " text; fails the test if it ends otherwise, or not within some time.")
        .takes("message", Type.STRING, Value.of(""))
        .takes("within", Unit.SECOND, USUAL_S)
        .physicalTime()
        .does(call -> awaitEnd(call, Optional.of(call.text(0))));
  }

  private static Outcome post(Call<ControlBox> call, ProgramCommand command) throws ScriptError {
    TestBench bench = TestBuiltins.bench(call);
    if (!bench.running()) {
      throw call.failure("no-program", text("noProgramRuns"));
    }
    bench.post(command);
    return call.answer();
  }

  private static Outcome variable(Call<ControlBox> call) throws ScriptError {
    Value value = TestBuiltins.bench(call).globals().get(call.text(0));
    if (value == null) {
      throw call.refuse(0, text("noGlobal"));
    }
    call.charge(value.sizeBytes());
    return call.answer(value);
  }

  private static Outcome awaitEnd(Call<ControlBox> call, Optional<String> error)
      throws ScriptError {
    TestBench bench = TestBuiltins.bench(call);
    if (!bench.running() && bench.ending().isEmpty()) {
      throw call.failure("no-program", text("noProgramStarted"));
    }
    double within = call.number(error.isPresent() ? 1 : 0);
    if (!(within >= 0)) {
      throw call.refuse(error.isPresent() ? 1 : 0, text("notNegative"));
    }
    bench.expected().programFailure();
    return new AwaitEnd(bench, error, within, call.frame() + FrameTime.framesFor(within));
  }

  /** Waits for the end of the program under test and judges how it ended. */
  private record AwaitEnd(TestBench bench, Optional<String> error, double within, long deadline)
      implements Wait {
    @Override
    public Optional<Value> poll(long frame) throws ScriptError {
      Optional<Ending> ending = bench.ending();
      if (ending.isPresent()) {
        judge(ending.get());
        return DONE;
      }
      if (frame >= deadline) {
        throw failed(
            TestTexts.text(
                bench.paused() ? "programPaused" : "programRuns", Value.of(within).text()));
      }
      return Optional.empty();
    }

    private void judge(Ending ending) throws ScriptError {
      switch (ending) {
        case Ending.Failed(var why) -> {
          if (error.isEmpty()) {
            throw failed(TestTexts.text("programFailed", why.line(), why.message()));
          }
          if (!why.message().contains(error.get())) {
            throw failed(
                TestTexts.text("programFailedOtherwise", why.line(), why.message(), error.get()));
          }
        }
        case Ending.Stopped _ -> {
          if (error.isPresent()) {
            throw failed(text("stoppedMustFail"));
          }
        }
        case Ending.Finished _, Ending.Halted _ -> {
          if (error.isPresent()) {
            throw failed(text("endedMustFail"));
          }
        }
      }
    }

    private ScriptError failed(String what) {
      return new ScriptError(
          AssertionCodes.FAILED,
          (error.isPresent() ? "assert_program_fails" : "wait_for_end") + ": " + what);
    }
  }
}
