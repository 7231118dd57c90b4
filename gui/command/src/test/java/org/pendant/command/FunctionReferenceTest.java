package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.function.Builtins;

final class FunctionReferenceTest {

  private static Builtins<?> twoFunctionsAndAMethod() {
    Builtins<?> builtins = new Builtins<>();
    builtins
        .declare("wait_for")
        .manual("internals", "16.54")
        .doc("Waits for a while. The arm keeps moving meanwhile.")
        .needs("t", Unit.SECOND)
        .takes("a", Unit.METRE_PER_SECOND_SQUARED, 1.5)
        .mayTake("q", Type.JOINTS, Unit.RADIAN, "current joint positions")
        .physicalTime()
        .returns(Unit.METRE)
        .does(call -> call.answer());
    builtins
        .declare("alone")
        .manual("internals", "16.1")
        .doc("Does little.")
        .deprecated("wait_for")
        .does(call -> call.answer());
    builtins
        .declareMethod(Type.LIST, "alone")
        .manual("core", "4.3.1")
        .doc("Does less.")
        .does(call -> call.answer());
    return builtins;
  }

  @Test
  void tableHasOneSentenceForEachInTheOrderOfNames() {
    assertEquals(
        List.of(
            "Module internals",
            "  alone()                             Does little.",
            "  wait_for(t, a=1.5, q=<current joint positions>)",
            "                                      Waits for a while.",
            "",
            "Methods of a list",
            "  list.alone()                        Does less."),
        new FunctionReference(twoFunctionsAndAMethod()).table());
  }

  @Test
  void entryHasEverything() {
    assertEquals(
        """
        wait_for(t, a=1.5, q=<current joint positions>)

          Waits for a while. The arm keeps moving meanwhile.

          Parameters:
            t  number in s
            a  number in m/s², default 1.5
            q  list of 6 numbers in rad, default current joint positions

          Result: number in m
          Note:   Takes robot time; a secondary program cannot call it
          Manual: section 16.54\
        """,
        String.join("\n", new FunctionReference(twoFunctionsAndAMethod()).entries("wait_for")));
  }

  @Test
  void functionAndMethodOfOneNameAreBothExplained() {
    List<String> lines = new FunctionReference(twoFunctionsAndAMethod()).entries("alone");

    assertTrue(lines.contains("alone()"));
    assertTrue(lines.contains("list.alone()"));
    assertTrue(lines.contains("  Note:   Deprecated: use wait_for"));
  }

  @Test
  void unknownNameHasNoEntry() {
    assertEquals(List.of(), new FunctionReference(twoFunctionsAndAMethod()).entries("nothing"));
  }

  @Test
  void pageHasAHeadingForEveryFunctionOfTheCatalogue() {
    Builtins<?> builtins = StandardBuiltins.create();

    String page = new FunctionReference(builtins).markdown();

    for (Signature signature : builtins.all()) {
      assertTrue(page.contains(signature.head() + "`\n"), signature.name());
    }
  }
}
