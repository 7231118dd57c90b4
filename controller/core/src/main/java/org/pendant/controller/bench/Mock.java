package org.pendant.controller.bench;

import static org.pendant.controller.bench.BenchTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Mock: stands in for one function of the programs under test, answers in its place, or says which
 * function of the test does, and keeps what it was called with.
 */
public final class Mock {
  /** Most calls whose arguments are kept; more are only counted. */
  public static final int MAX_KEPT = 10_000;

  private final String function;
  private final Optional<String> by;
  private final List<Value> answers;
  private final List<List<Value>> calls = new ArrayList<>();
  private long count;

  /**
   * A mock.
   *
   * @param answers of the first call, the second and so on; the last one stays
   */
  Mock(String function, List<Value> answers) {
    this.function = function;
    this.answers = List.copyOf(answers);
    by = Optional.empty();
  }

  /**
   * A mock whose answers a function of the test gives.
   *
   * @param by its name
   */
  Mock(String function, String by) {
    this.function = function;
    this.by = Optional.of(by);
    answers = List.of(NoneValue.NONE);
  }

  /** The function of the test that answers, where one does. */
  public Optional<String> by() {
    return by;
  }

  /** The name of what it stands in for. */
  public String function() {
    return function;
  }

  /**
   * Answers a call.
   *
   * @param arguments copies of them
   */
  public Value answer(List<Value> arguments) {
    int number = (int) Math.min(count, answers.size() - 1L);
    note(arguments);
    return answers.get(number).copy();
  }

  /**
   * Keeps a call that a function of the test is going to answer.
   *
   * @param arguments copies of them
   */
  void note(List<Value> arguments) {
    count++;
    if (calls.size() < MAX_KEPT) {
      calls.add(List.copyOf(arguments));
    }
  }

  /** How often it was called. */
  public long count() {
    return count;
  }

  /**
   * The argument that a call had.
   *
   * @param call counted from 0
   * @param argument counted from 0
   * @throws ScriptError if there was no such call or it had no such argument
   */
  public Value argument(int call, int argument) throws ScriptError {
    if (call < 0 || call >= calls.size()) {
      throw new ScriptError("no-such-call", text("noSuchCall", function, count, call));
    }
    List<Value> given = calls.get(call);
    if (argument < 0 || argument >= given.size()) {
      throw new ScriptError(
          "no-such-call", text("noSuchArgument", function, given.size(), argument));
    }
    return given.get(argument).copy();
  }

  /** The answers that a list of them stands for; any other value is the only one. */
  static List<Value> answersOf(Value value) throws ScriptError {
    List<Value> answers = new ArrayList<>();
    switch (value) {
      case NumberList list when list.length() > 0 -> {
        for (int i = 0; i < list.length(); i++) {
          answers.add(list.get(i));
        }
      }
      case ObjectList list when list.length() > 0 -> {
        for (int i = 0; i < list.length(); i++) {
          answers.add(list.get(i).copy());
        }
      }
      default -> answers.add(value.copy());
    }
    return answers;
  }
}
