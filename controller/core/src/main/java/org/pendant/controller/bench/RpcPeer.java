package org.pendant.controller.bench;

import static org.pendant.controller.bench.BenchTexts.text;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.external.Pending;
import org.pendant.controller.external.RpcConnector;
import org.pendant.controller.external.RpcLink;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * RPC peer: the server of remote procedures that programs under test reach at any address, played
 * by their test: each procedure that the test has given an answer is there. Answers come at once,
 * those of functions in the next frame.
 */
public final class RpcPeer implements RpcConnector {
  private final Map<String, Mock> procedures = new HashMap<>();
  private final MockedCalls calls;

  RpcPeer(MockedCalls calls) {
    this.calls = calls;
  }

  /**
   * Answers calls of a procedure from now on.
   *
   * @param answer the one answer, or a list of answers for one call after the other
   */
  public void answer(String procedure, Value answer) throws ScriptError {
    procedures.put(procedure, new Mock(procedure, Mock.answersOf(answer)));
  }

  /** Has a function of the test answer calls of a procedure from now on. */
  public void answerBy(String procedure, String by) {
    procedures.put(procedure, new Mock(procedure, by));
  }

  /** What answers a procedure, and how it was called. */
  public Optional<Mock> procedure(String name) {
    return Optional.ofNullable(procedures.get(name));
  }

  @Override
  public RpcLink open(String url) throws ScriptError {
    if (procedures.isEmpty()) {
      throw new ScriptError("no-outside", text("noServer", url));
    }
    return new Link();
  }

  /** A connection of a program. */
  private final class Link implements RpcLink {
    @Override
    public Pending connect() {
      return new Answered(NoneValue.NONE);
    }

    @Override
    public Pending call(String method, List<Value> arguments) throws ScriptError {
      Mock mock = procedures.get(method);
      if (mock == null) {
        throw new ScriptError("no-such-procedure", text("noAnswer", method));
      }
      List<Value> copies = arguments.stream().map(Value::copy).toList();
      return mock.by().isPresent()
          ? calls.ask(mock, copies.size(), copies)
          : new Answered(mock.answer(copies));
    }

    @Override
    public void disconnect() {}

    @Override
    public void close() {}
  }

  /** An answer that is there. */
  private record Answered(Value result) implements Pending {
    @Override
    public boolean over() {
      return true;
    }

    @Override
    public void cancel() {}
  }
}
