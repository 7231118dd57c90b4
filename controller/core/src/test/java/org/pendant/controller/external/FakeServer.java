package org.pendant.controller.external;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** A server of remote procedures without a network: a test says what it answers. */
public final class FakeServer implements RpcLink {
  private final List<String> calls = new ArrayList<>();
  private final List<FakePending> pending = new ArrayList<>();

  /** An answer that comes when a test wants it. */
  private static final class FakePending implements Pending {
    private Optional<Value> value = Optional.empty();
    private Optional<ScriptError> failure = Optional.empty();
    private boolean cancelled;

    @Override
    public boolean over() {
      return value.isPresent() || failure.isPresent();
    }

    @Override
    public Value result() throws ScriptError {
      if (failure.isPresent()) {
        throw failure.get();
      }
      return value.orElseThrow();
    }

    @Override
    public void cancel() {
      cancelled = true;
    }
  }

  /** The calls with their arguments as text, and what else was asked. */
  public List<String> calls() {
    return calls;
  }

  /** Answers the oldest call that waits. */
  public void answer(Value value) {
    pending.removeFirst().value = Optional.of(value);
  }

  /** Fails the oldest call that waits. */
  public void fail(ScriptError failure) {
    pending.removeFirst().failure = Optional.of(failure);
  }

  /** Whether nobody waits for the oldest call any more. */
  public boolean cancelled() {
    return pending.getFirst().cancelled;
  }

  private Pending wait(String call) {
    calls.add(call);
    FakePending made = new FakePending();
    pending.add(made);
    return made;
  }

  @Override
  public Pending connect() {
    Pending made = wait("connect");
    answer(NoneValue.NONE);
    return made;
  }

  @Override
  public Pending call(String method, List<Value> arguments) {
    return wait(method + arguments.stream().map(Value::text).toList());
  }

  @Override
  public void disconnect() {
    calls.add("disconnect");
  }

  @Override
  public void close() {
    calls.add("close");
  }
}
