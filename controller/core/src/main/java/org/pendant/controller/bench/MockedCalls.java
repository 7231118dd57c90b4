package org.pendant.controller.bench;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.script.value.Value;

/**
 * Mocked calls: calls of replaced functions that functions of the test answer. The caller waits; a
 * thread of the test takes the call, runs the function, and gives its result.
 */
public final class MockedCalls {
  /** What has been called and no thread has taken yet. */
  private final Deque<MockedCall> waiting = new ArrayDeque<>();

  private final Map<Integer, MockedCall> taken = new HashMap<>();
  private int announced;
  private int numbered;

  MockedCalls() {}

  /**
   * A replaced function is called.
   *
   * @param mock answered by a function of the test
   * @param needed how many arguments each call of it has at least
   * @param arguments copies of them
   */
  public MockedCall ask(Mock mock, int needed, List<Value> arguments) {
    mock.note(arguments);
    MockedCall call = new MockedCall(mock, needed, arguments);
    waiting.add(call);
    return call;
  }

  /** Announces a call that a thread is going to take; answers whether there is one. */
  public boolean announce() {
    waiting.removeIf(MockedCall::over);
    boolean more = waiting.size() > announced;
    announced += more ? 1 : 0;
    return more;
  }

  /**
   * Takes the oldest call that nobody has taken.
   *
   * @return its number; -1 where there is none any more
   */
  public int take() {
    announced = Math.max(0, announced - 1);
    waiting.removeIf(MockedCall::over);
    if (waiting.isEmpty()) {
      return -1;
    }
    taken.put(numbered, waiting.remove());
    return numbered++;
  }

  /** The call of a number; empty where it has its answer. */
  public Optional<MockedCall> taken(int number) {
    return Optional.ofNullable(taken.get(number));
  }

  /** Answers a call that was taken. */
  public void answer(int number, Value answer) {
    MockedCall call = taken.remove(number);
    if (call != null) {
      call.answer(answer);
    }
  }
}
