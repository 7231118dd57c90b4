package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Effect;

/** Each function says what it does, and that agrees with what else is declared of it. */
final class BuiltinEffectTest {
  private static final Optional<Type> LIST = Optional.of(Type.LIST);

  private final Builtins<?> builtins = StandardBuiltins.create();

  private List<Builtin<?>> having(Effect effect) {
    return builtins.all().stream().map(this::of).filter(each -> each.effect() == effect).toList();
  }

  private Builtin<?> of(Signature signature) {
    return signature.receiver().isPresent()
        ? builtins.findMethod(signature.receiver().get(), signature.name()).orElseThrow()
        : builtins.find(signature.name()).orElseThrow();
  }

  private Effect effect(String name) {
    return builtins.find(name).orElseThrow().effect();
  }

  @Test
  void everyFunctionThatTakesTimeMovesOrChanges() {
    for (Signature signature : builtins.all()) {
      if (signature.physicalTime() && of(signature).effect() != Effect.MOVES) {
        assertEquals(Effect.CHANGES, of(signature).effect(), signature.name());
      }
    }
  }

  private static List<Builtin<?>> concat(List<Builtin<?>> some, List<Builtin<?>> others) {
    return Stream.concat(some.stream(), others.stream()).toList();
  }

  @Test
  void everyMoveTakesTime() {
    List<Builtin<?>> moves = having(Effect.MOVES);
    assertEquals(
        List.of("movec", "movej", "movel", "movep", "optimovej", "optimovel"),
        moves.stream().map(Builtin::name).sorted().toList());
    moves.forEach(move -> assertEquals(true, move.signature().physicalTime(), move.name()));
  }

  @Test
  void whatOnlyTellsAnswersAtMostWhetherItDid() {
    for (Builtin<?> builtin : having(Effect.TELLS)) {
      Type result = builtin.signature().result();
      assertTrue(result == Type.NONE || result == Type.BOOL, builtin.name() + ": " + result);
    }
  }

  @Test
  void whatOnlyAsksHasAnAnswer() {
    for (Builtin<?> builtin : concat(having(Effect.ASKS), having(Effect.SENSES))) {
      assertNotEquals(Type.NONE, builtin.signature().result(), builtin.name());
    }
  }

  @Test
  void mathematicsComputesExceptForRandomNumbers() {
    for (Signature signature : builtins.all()) {
      if (signature.module().equals("urmath") || signature.receiver().equals(LIST)) {
        Effect expected = signature.name().equals("random") ? Effect.CHANGES : Effect.COMPUTES;
        assertEquals(expected, of(signature).effect(), signature.name());
      }
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "get_actual_tcp_pose",
        "get_joint_positions",
        "get_target_tcp_speed",
        "get_tcp_force",
        "is_steady",
        "get_conveyor_tick_count",
        "get_tool_current",
        "time"
      })
  void whatWillBeAnotherThenIsSensed(String name) {
    assertEquals(Effect.SENSES, effect(name));
  }

  @ParameterizedTest
  @ValueSource(strings = {"set_payload", "set_tool_digital_output_mode", "socket_read_line"})
  void whatChangesAnythingIsNotForeseen(String name) {
    assertEquals(Effect.CHANGES, effect(name));
  }

  @ParameterizedTest
  @ValueSource(strings = {"str_len", "to_num", "pose_trans", "norm", "assert"})
  void whatDependsOnArgumentsAloneIsForeseen(String name) {
    assertEquals(Effect.COMPUTES, effect(name));
  }

  @ParameterizedTest
  @ValueSource(strings = {"get_standard_digital_in", "read_input_float_register", "get_tcp_offset"})
  void inputsAndSettingsAreAskedAsTheyAreNow(String name) {
    assertEquals(Effect.ASKS, effect(name));
  }
}
