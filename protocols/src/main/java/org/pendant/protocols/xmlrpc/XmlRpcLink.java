package org.pendant.protocols.xmlrpc;

import static org.pendant.protocols.xmlrpc.XmlRpcTexts.text;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.apache.xmlrpc.XmlRpcException;
import org.apache.xmlrpc.client.XmlRpcClient;
import org.apache.xmlrpc.client.XmlRpcClientConfigImpl;
import org.pendant.controller.external.Pending;
import org.pendant.controller.external.RpcLink;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * XML-RPC link: one handle of a script. Its calls take turns, each in a thread of its own: a server
 * that serves one connection at a time would never come to a second one.
 */
final class XmlRpcLink implements RpcLink {
  private static final int MAX_MESSAGE = 300;

  private final Wire wire;
  private final Consumer<RpcLink> afterwards;
  private final XmlRpcClient client = new XmlRpcClient();
  private final ReentrantLock turn = new ReentrantLock(true);
  private final AtomicBoolean closingFirst = new AtomicBoolean();
  private final Set<RpcTask> tasks = ConcurrentHashMap.newKeySet();

  /**
   * A handle for the server at the end of {@code wire}.
   *
   * @param afterwards told when it is closed
   */
  XmlRpcLink(Wire wire, Consumer<RpcLink> afterwards) {
    this.wire = wire;
    this.afterwards = afterwards;
    XmlRpcClientConfigImpl config = new XmlRpcClientConfigImpl();
    config.setEncoding("UTF-8");
    client.setConfig(config);
    client.setTypeFactory(new ScriptTypes(client));
    client.setTransportFactory(() -> new WireTransport(client, wire));
  }

  @Override
  public Pending connect() {
    return begin(
        () -> {
          wire.probe();
          return NoneValue.NONE;
        });
  }

  @Override
  public Pending call(String method, List<Value> arguments) throws ScriptError {
    List<Object> sent = new ArrayList<>(arguments.size());
    for (int i = 0; i < arguments.size(); i++) {
      try {
        sent.add(ValueXml.toXml(arguments.get(i)));
      } catch (ScriptError e) {
        throw new ScriptError(e.code(), text("argument", i + 1, e.getMessage()));
      }
    }
    return begin(() -> ValueXml.fromXml(client.execute(method, sent)));
  }

  private Pending begin(Callable<Value> work) {
    RpcTask task = new RpcTask(() -> inTurn(work), tasks::remove);
    tasks.add(task);
    task.begin();
    return task;
  }

  private Value inTurn(Callable<Value> work) throws Exception {
    turn.lockInterruptibly();
    try {
      if (closingFirst.getAndSet(false)) {
        wire.close();
      }
      return work.call();
    } catch (XmlRpcFault e) {
      throw new ScriptError("rpc-fault", text("fault", e.code, shortened(e.getMessage())));
    } catch (XmlRpcException e) {
      throw new ScriptError("rpc-failed", shortened(cause(e)));
    } catch (IOException e) {
      throw new ScriptError("rpc-failed", shortened(e.getMessage()));
    } finally {
      turn.unlock();
    }
  }

  /** The library wraps what our own connection says. */
  private static String cause(XmlRpcException e) {
    return e.getCause() instanceof IOException io && io.getMessage() != null
        ? io.getMessage()
        : e.getMessage();
  }

  private static String shortened(String text) {
    String line = String.valueOf(text).replaceAll("\\p{Cntrl}+", " ").strip();
    return line.length() > MAX_MESSAGE ? line.substring(0, MAX_MESSAGE) + "..." : line;
  }

  @Override
  public void disconnect() {
    // whichever turn comes next: that of a later call, or this one; one is enough for all that ask
    if (!closingFirst.getAndSet(true)) {
      var _ = begin(() -> NoneValue.NONE);
    }
  }

  @Override
  public void close() {
    tasks.forEach(RpcTask::cancel);
    afterwards.accept(this);
    Thread.ofVirtual().name("RPC closing").start(wire::close);
  }
}
