package org.pendant.controller.bench;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.external.Pending;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.Value;

/** Mocked call: one call of a replaced function that waits for a function of the test. */
public final class MockedCall implements Pending {
  private final Mock mock;
  private final int needed;
  private final List<Value> arguments;
  private Optional<Value> answer = Optional.empty();

  MockedCall(Mock mock, int needed, List<Value> arguments) {
    this.mock = mock;
    this.needed = needed;
    this.arguments = List.copyOf(arguments);
  }

  /** What was called. */
  public Mock mock() {
    return mock;
  }

  /** How many arguments each call of it has at least. */
  public int needed() {
    return needed;
  }

  /** The arguments; those that the caller has left out and that have no default are not there. */
  public List<Value> arguments() {
    return arguments;
  }

  void answer(Value value) {
    answer = Optional.of(value);
  }

  @Override
  public boolean over() {
    return answer.isPresent();
  }

  @Override
  public Value result() {
    return answer.orElseThrow();
  }

  @Override
  public void cancel() {
    answer = Optional.of(NoneValue.NONE);
  }
}
