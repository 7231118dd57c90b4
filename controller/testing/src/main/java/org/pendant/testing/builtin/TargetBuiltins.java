package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.script.function.BuiltinCode;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.testing.remote.TargetState;
import org.pendant.testing.remote.TargetView;

/**
 * Builtins of tests of a target: what asks the box asks the target's last state, what does
 * something to the box is posted to the target, and everything else that the box would answer is
 * refused, see {@link TargetLimits}.
 */
public final class TargetBuiltins {
  /** Frames for which a line of the log is waited for, which comes another way than states do. */
  private static final long LINE_FRAMES = 500;

  /** Frames for which variables are waited for that the target tells ten times a second. */
  private static final long VARIABLE_FRAMES = 500;

  private static final int LOW_BITS = 32;
  private static final int SINGLE_BITS = 64;
  private static final int REGISTERS = 48;
  private static final int BIT_REGISTERS = 128;
  private static final Optional<Value> DONE = Optional.of(NoneValue.NONE);

  /** What every test has. */
  private static final List<String> ALWAYS =
      List.of(
          TargetState.TIME,
          TargetState.RUN_STATE,
          TargetState.ROBOT_MODE,
          TargetState.SAFETY_STATUS,
          TargetState.SAFETY_MODE,
          TargetState.SPEED,
          TargetState.INPUTS,
          TargetState.OUTPUTS,
          "actual_TCP_pose");

  private final TargetView view;
  private final Map<String, BuiltinCode<ControlBox>> codes = new HashMap<>();

  private TargetBuiltins(TargetView view) {
    this.view = view;
  }

  /**
   * A catalogue for tests of a target.
   *
   * @param view has what the target has told
   */
  public static Builtins<ControlBox> create(TargetView view) {
    Builtins<ControlBox> plain = TestBuiltins.create();
    TargetBuiltins target = new TargetBuiltins(view);
    plain
        .all()
        .forEach(
            each ->
                TargetLimits.reason(plain, each.name())
                    .ifPresent(why -> target.codes.put(each.name(), refusing(why))));
    target.declareStates();
    target.declareRegisters();
    target.declareOperator();
    return plain.replacing(target.codes);
  }

  private static BuiltinCode<ControlBox> refusing(String why) {
    return call -> {
      throw new ScriptError("not-at-target", why);
    };
  }

  /** The quantities that a target has to tell to tests that call these functions. */
  public static Set<String> quantities(Set<String> functions) {
    Set<String> names = new LinkedHashSet<>(ALWAYS);
    TargetLimits.VECTORS.forEach(
        (function, quantity) -> {
          if (functions.contains(function)) {
            names.add(quantity);
          }
        });
    TargetLimits.ANALOGS.forEach(
        (function, quantity) -> {
          if (functions.contains(function)) {
            names.add(quantity + 0);
            names.add(quantity + 1);
          }
        });
    for (RegisterDirection direction : RegisterDirection.values()) {
      String read = "read_" + direction.text();
      if (functions.contains(read + "_integer_register")) {
        addAll(names, direction.text() + "_int_register_");
      }
      if (functions.contains(read + "_float_register")) {
        addAll(names, direction.text() + "_double_register_");
      }
      if (functions.contains(read + "_boolean_register")
          || functions.contains("write_" + direction.text() + "_boolean_register")) {
        names.add(direction.text() + "_bit_registers0_to_31");
        names.add(direction.text() + "_bit_registers32_to_63");
        for (int i = SINGLE_BITS; i < BIT_REGISTERS; i++) {
          names.add(direction.text() + "_bit_register_" + i);
        }
      }
    }
    return names;
  }

  private static void addAll(Set<String> names, String prefix) {
    for (int i = 0; i < REGISTERS; i++) {
      names.add(prefix + i);
    }
  }

  private double[] numbers(Call<ControlBox> call, String quantity) throws ScriptError {
    return view.state()
        .numbers(quantity)
        .orElseThrow(() -> call.failure("not-at-target", text("notTold", quantity)));
  }

  private void declareStates() {
    digital("get_standard_digital_in", SignalBank.STANDARD_IN);
    digital("get_standard_digital_out", SignalBank.STANDARD_OUT);
    digital("get_configurable_digital_in", SignalBank.CONFIGURABLE_IN);
    digital("get_configurable_digital_out", SignalBank.CONFIGURABLE_OUT);
    digital("get_tool_digital_in", SignalBank.TOOL_IN);
    digital("get_tool_digital_out", SignalBank.TOOL_OUT);
    old("get_digital_in", SignalBank.STANDARD_IN, SignalBank.TOOL_IN);
    old("get_digital_out", SignalBank.STANDARD_OUT, SignalBank.TOOL_OUT);
    TargetLimits.VECTORS.forEach(
        (function, quantity) ->
            codes.put(
                function,
                function.endsWith("joint_positions") || function.endsWith("joint_speeds")
                    ? call -> call.answer(Joints.of(numbers(call, quantity)))
                    : call -> call.answer(pose(numbers(call, quantity)))));
    codes.put("force", call -> call.answer(length(numbers(call, "actual_TCP_force"))));
    TargetLimits.ANALOGS.forEach(
        (function, quantity) ->
            codes.put(
                function, call -> call.answer(numbers(call, quantity + call.integer(0, 0, 1))[0])));
    codes.put(
        "tcp_inside", call -> NearBuiltins.inside(call, pose(numbers(call, "actual_TCP_pose"))));
    codes.put("safety_mode", call -> call.answer(view.safetyMode()));
  }

  private void digital(String function, SignalBank bank) {
    codes.put(
        function,
        call ->
            call.answer(
                view.state()
                    .levels()
                    .level(new Signal(bank, call.integer(0, 0, bank.size() - 1)))));
  }

  /** A name of older software, in which the tool's signals are 8 and 9. */
  private void old(String function, SignalBank standard, SignalBank tool) {
    codes.put(
        function,
        call -> {
          int n = call.integer(0, 0, standard.size() + tool.size() - 1);
          Signal signal =
              n < standard.size() ? new Signal(standard, n) : new Signal(tool, n - standard.size());
          return call.answer(view.state().levels().level(signal));
        });
  }

  private static Pose pose(double[] numbers) {
    return new Pose(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]);
  }

  private static double length(double[] force) {
    return Math.sqrt(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
  }

  private void declareRegisters() {
    for (RegisterDirection direction : RegisterDirection.values()) {
      String word = direction.text();
      codes.put(
          "read_" + word + "_integer_register",
          call ->
              call.answerInt(
                  (int)
                      numbers(call, word + "_int_register_" + call.integer(0, 0, REGISTERS - 1))[
                          0]));
      codes.put(
          "read_" + word + "_float_register",
          call ->
              call.answer(
                  numbers(call, word + "_double_register_" + call.integer(0, 0, REGISTERS - 1))[
                      0]));
      codes.put("read_" + word + "_boolean_register", call -> bit(call, word));
    }
    codes.put(
        "write_input_boolean_register",
        call ->
            write(
                call,
                new SignalWrite.BooleanRegister(
                    RegisterDirection.INPUT, call.integer(0, 0, BIT_REGISTERS - 1), call.bool(1))));
    codes.put(
        "write_input_integer_register",
        call ->
            write(
                call,
                new SignalWrite.IntegerRegister(
                    RegisterDirection.INPUT, call.integer(0, 0, REGISTERS - 1), call.integer(1))));
    codes.put(
        "write_input_float_register",
        call ->
            write(
                call,
                new SignalWrite.FloatRegister(
                    RegisterDirection.INPUT, call.integer(0, 0, REGISTERS - 1), call.number(1))));
  }

  private Outcome bit(Call<ControlBox> call, String word) throws ScriptError {
    int n = call.integer(0, 0, BIT_REGISTERS - 1);
    if (n >= SINGLE_BITS) {
      return call.answer(numbers(call, word + "_bit_register_" + n)[0] != 0);
    }
    String quantity = word + (n < LOW_BITS ? "_bit_registers0_to_31" : "_bit_registers32_to_63");
    return call.answer(((long) numbers(call, quantity)[0] >> n % LOW_BITS & 1) != 0);
  }

  private static Outcome write(Call<ControlBox> call, SignalWrite write) {
    TestBuiltins.bench(call).post(new IoCommand.WriteSignals(InputOwners.BY_HAND, List.of(write)));
    return call.answer();
  }

  private void declareOperator() {
    codes.put("log_contains", call -> call.answer(logged(call, call.text(0))));
    codes.put("assert_log", this::awaitLine);
    codes.put("program_variable", this::awaitVariable);
    codes.put(
        "popup_open",
        call -> {
          String part = call.text(0);
          return call.answer(view.popups().values().stream().anyMatch(each -> each.contains(part)));
        });
    codes.put(
        "close_popup",
        call -> {
          long oldest =
              view.popups().keySet().stream()
                  .min(Long::compare)
                  .orElseThrow(() -> call.failure("no-popup", text("noPopup")));
          TestBuiltins.bench(call).post(new MessageCommand.AnswerPopup(oldest));
          return call.answer();
        });
  }

  /** What the target has begun to tell before it was asked may be older than what the test saw. */
  private Outcome awaitVariable(Call<ControlBox> call) throws ScriptError {
    String name = call.text(0);
    long begun = view.variables().begun();
    long last = call.frame() + VARIABLE_FRAMES;
    Wait wait =
        frame -> {
          boolean told = view.variablesSince(begun);
          Value value = told ? view.variables().values().get(name) : null;
          if (value != null) {
            return Optional.of(value.copy());
          }
          if (frame < last) {
            // a program that has just started may not have come to it
            return Optional.empty();
          }
          throw told
              ? new ScriptError("bad-argument", text("noVariable", name))
              : new ScriptError("not-at-target", text("noVariablesTold"));
        };
    return wait;
  }

  private boolean logged(Call<ControlBox> call, String part) {
    call.charge(view.lines().size());
    return view.lines().stream().anyMatch(each -> each.contains(part));
  }

  private Outcome awaitLine(Call<ControlBox> call) throws ScriptError {
    String part = call.text(0);
    String shown = AssertionBuiltins.shown(call.value(0));
    long last = call.frame() + LINE_FRAMES;
    if (logged(call, part)) {
      return call.answer();
    }
    Wait wait =
        frame -> {
          if (view.lines().stream().anyMatch(each -> each.contains(part))) {
            return DONE;
          }
          if (frame >= last) {
            throw new ScriptError(AssertionCodes.FAILED, text("assertLog", shown));
          }
          return Optional.empty();
        };
    return wait;
  }
}
