package org.pendant.controller.bench;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Mocks: which functions of the programs under test are replaced just now. */
public final class Mocks {
  private final Map<String, Mock> active = new HashMap<>();
  private final MockedCalls calls = new MockedCalls();

  Mocks() {}

  /**
   * Replaces a function from now on.
   *
   * @param answer the one answer, or a list of answers for one call after the other
   */
  public void replace(String function, Value answer) throws ScriptError {
    active.put(function, new Mock(function, Mock.answersOf(answer)));
  }

  /** As {@link #replace}, with a single answer that may be a list itself. */
  public void replaceByOne(String function, Value answer) {
    active.put(function, new Mock(function, List.of(answer.copy())));
  }

  /**
   * Replaces a function by one of the test, which gets the arguments of each call and answers.
   *
   * @param by its name
   */
  public void replaceByFunction(String function, String by) {
    active.put(function, new Mock(function, by));
  }

  /** The calls that functions of the test have to answer. */
  public MockedCalls calls() {
    return calls;
  }

  /** Has a function do again what it does. */
  public void restore(String function) {
    active.remove(function);
  }

  /** The functions that are replaced just now. */
  public Set<String> functions() {
    return Set.copyOf(active.keySet());
  }

  /** What stands in for a function; empty where it does itself what it does. */
  public Optional<Mock> of(String function) {
    return Optional.ofNullable(active.get(function));
  }
}
