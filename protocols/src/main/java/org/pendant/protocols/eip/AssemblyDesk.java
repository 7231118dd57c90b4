package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.pendant.controller.Command;
import org.pendant.controller.Controller;
import org.pendant.controller.Reply;
import org.pendant.controller.eip.AssemblyData;
import org.pendant.controller.eip.AssemblyImage;
import org.pendant.controller.eip.AssemblyPair;

/** The assemblies of a controller, the built-in ones and those that were configured. Any thread. */
final class AssemblyDesk {
  /** A frame takes 2 ms: who gets no answer for this long speaks to a box that has stopped. */
  private static final long PATIENCE_S = 5;

  /** When to ask again, ms. */
  private static final long AGAIN_MS = 2;

  private final Controller controller;

  AssemblyDesk(Controller controller) {
    this.controller = controller;
  }

  /** The size of an assembly that the scanner writes. */
  OptionalInt fromScannerBytes(int instance) {
    return instance == AssemblyPair.BUILT_IN_FROM_PLC
        ? OptionalInt.of(ControlAssembly.BYTES)
        : image()
            .fromPlc(instance)
            .map(data -> OptionalInt.of(data.size()))
            .orElse(OptionalInt.empty());
  }

  /** The size of an assembly that the robot writes. */
  OptionalInt toScannerBytes(int instance) {
    return instance == AssemblyPair.BUILT_IN_TO_PLC
        ? OptionalInt.of(StateAssembly.BYTES)
        : image()
            .toPlc(instance)
            .map(data -> OptionalInt.of(data.size()))
            .orElse(OptionalInt.empty());
  }

  /** What the robot writes now; no bytes when there is no such assembly. */
  ByteBuffer toScanner(int instance) {
    return instance == AssemblyPair.BUILT_IN_TO_PLC
        ? StateAssembly.of(controller.state())
        : ByteBuffer.wrap(image().toPlc(instance).map(AssemblyData::toArray).orElse(new byte[0]));
  }

  /** What was configured. */
  AssemblyImage image() {
    return controller.state().assemblies();
  }

  /**
   * The scanner that has an assembly writes it.
   *
   * @param data as many bytes as it has
   */
  void write(String owner, int instance, ByteBuffer data) {
    Command command =
        instance == AssemblyPair.BUILT_IN_FROM_PLC
            ? new Command.WriteInputs(owner, ControlAssembly.decode(data))
            : new Command.ReceiveAssembly(instance, AssemblyData.of(data));
    // nobody waits: data that find no place among the commands of a frame are followed by others
    var _ = controller.submit(command);
  }

  /** Takes what an assembly writes; answers whether nobody else has some of it. */
  boolean claim(String owner, int instance) throws InterruptedException {
    if (instance != AssemblyPair.BUILT_IN_FROM_PLC) {
      return true;
    }
    CompletableFuture<Set<String>> inUse = new CompletableFuture<>();
    ask(new Command.ClaimInputs(owner, ControlAssembly.RECIPE, inUse::complete));
    // a box that does not answer gives nothing away
    return inUse.getNow(ControlAssembly.RECIPE.names()).isEmpty();
  }

  /** Gives back what an owner has taken. */
  void release(String owner) throws InterruptedException {
    ask(new Command.ReleaseSignals(owner));
  }

  /** The scanner that writes an assembly has gone; what follows is up to the installation. */
  void lost(String owner) {
    var _ = controller.submit(new Command.ScannerLost(owner));
  }

  /** Makes a pair of assemblies; answers whether they are there. */
  boolean configure(AssemblyPair pair) throws InterruptedException {
    return answer(new Command.ConfigureAssemblies(pair)) instanceof Reply.Done;
  }

  /** Has a command carried out that is refused only while too many others wait. */
  private void ask(Command command) throws InterruptedException {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    while (!(answer(command) instanceof Reply.Done) && System.nanoTime() < endNs) {
      TimeUnit.MILLISECONDS.sleep(AGAIN_MS);
    }
  }

  private Reply answer(Command command) throws InterruptedException {
    try {
      return controller.submit(command).get(PATIENCE_S, TimeUnit.SECONDS);
    } catch (TimeoutException e) {
      return new Reply.Refused("the controller does not answer");
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }
}
