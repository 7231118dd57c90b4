package org.pendant.protocols.xmlrpc;

import static org.pendant.protocols.xmlrpc.XmlRpcTexts.text;

import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.Consumer;
import org.pendant.controller.external.Pending;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** RPC task: work that waits for a server, in a thread of its own. */
final class RpcTask implements Pending {
  private final FutureTask<Value> work;
  private final Consumer<RpcTask> afterwards;

  /**
   * Work that {@link #begin} begins.
   *
   * @param afterwards told when it is over
   */
  RpcTask(Callable<Value> work, Consumer<RpcTask> afterwards) {
    this.work = new FutureTask<>(work);
    this.afterwards = afterwards;
  }

  void begin() {
    Thread.ofVirtual().name("RPC").start(this::run);
  }

  private void run() {
    try {
      work.run();
    } finally {
      afterwards.accept(this);
    }
  }

  @Override
  public boolean over() {
    return work.isDone();
  }

  @Override
  public Value result() throws ScriptError {
    try {
      return work.get();
    } catch (ExecutionException e) {
      if (e.getCause() instanceof ScriptError failure) {
        throw failure;
      }
      throw new IllegalStateException("remote procedure call", e.getCause());
    } catch (CancellationException e) {
      throw new ScriptError("rpc-failed", text("givenUp"));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new ScriptError("rpc-failed", text("givenUp"));
    }
  }

  /** Interrupts it, which closes the connection that it waits for. */
  @Override
  public void cancel() {
    work.cancel(true);
  }
}
