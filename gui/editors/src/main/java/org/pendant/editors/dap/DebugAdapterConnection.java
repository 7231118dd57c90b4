package org.pendant.editors.dap;

import java.io.InputStream;
import java.io.OutputStream;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.eclipse.lsp4j.debug.services.IDebugProtocolClient;
import org.eclipse.lsp4j.jsonrpc.Launcher;
import org.eclipse.lsp4j.jsonrpc.debug.DebugLauncher;
import org.pendant.editors.dap.run.AttachableRobot;
import org.pendant.editors.dap.run.DebugTargets;
import org.pendant.editors.wire.CheckedFrames;

/** Debug adapter connection: serves one client over two streams until it leaves. */
public final class DebugAdapterConnection {
  private DebugAdapterConnection() {}

  /**
   * Serves the client until it disconnects or its stream ends; the caller waits.
   *
   * @param targets makes what is debugged
   * @param robot that the client may attach to
   * @param faults is told of what goes wrong in the adapter itself
   * @param complaints is told what of the client's bytes is left out
   * @throws InterruptedException if the thread is interrupted
   */
  public static void serve(
      DebugTargets targets,
      Optional<AttachableRobot> robot,
      InputStream input,
      OutputStream output,
      Consumer<Throwable> faults,
      Consumer<String> complaints)
      throws InterruptedException {
    ExecutorService reader =
        Executors.newSingleThreadExecutor(
            Thread.ofPlatform().daemon().name("debug adapter reader").factory());
    CompletableFuture<Boolean> left = new CompletableFuture<>();
    SessionThread turns = new SessionThread();
    CompletableFuture<IDebugProtocolClient> client = new CompletableFuture<>();
    try (DebugAdapter adapter =
        new DebugAdapter(targets, robot, turns, client::join, () -> left.complete(true))) {
      Launcher<IDebugProtocolClient> launcher =
          new DebugLauncher.Builder<IDebugProtocolClient>()
              .setLocalServices(
                  Stream.concat(Stream.of(adapter), adapter.beyondTheProtocol().stream()).toList())
              .setRemoteInterface(IDebugProtocolClient.class)
              .setClassLoader(IDebugProtocolClient.class.getClassLoader())
              .setInput(new CheckedFrames(input, complaints))
              .setOutput(output)
              .setExecutorService(reader)
              .wrapMessages(turns::gated)
              .setExceptionHandler(fault -> Refusals.told(fault, faults, adapter::shown))
              .create();
      client.complete(launcher.getRemoteProxy());
      var _ = launcher.startListening();
      // The one thread comes to this when the client's stream has ended.
      reader.execute(() -> left.complete(true));
      left.get();
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    } finally {
      reader.shutdownNow();
    }
  }
}
