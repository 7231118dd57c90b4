package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import org.pendant.controller.Deadline;
import org.pendant.controller.InstallationCommand;
import org.pendant.controller.PendingCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.eip.AssemblyCommand;
import org.pendant.controller.eip.AssemblyData;
import org.pendant.controller.eip.AssemblyImage;
import org.pendant.controller.eip.AssemblyPair;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.rtde.ControlAssembly;
import org.pendant.controller.rtde.RtdeCommand;

/** Assembly handler: the controller's assemblies, built in and configured. Any thread. */
final class AssemblyHandler {
  private static final Duration PATIENCE = Duration.ofSeconds(5);

  private final Robot robot;
  private final StateAssembly state = new StateAssembly();

  /** What each scanner has written last, as long as no frame has taken it. */
  private final Map<String, PendingCommand> newest = new ConcurrentHashMap<>();

  AssemblyHandler(Robot robot) {
    this.robot = robot;
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
        ? state.of(robot.state())
        : ByteBuffer.wrap(image().toPlc(instance).map(AssemblyData::toArray).orElse(new byte[0]));
  }

  /** What was configured. */
  AssemblyImage image() {
    return robot.state().assemblies();
  }

  /**
   * The scanner that has an assembly writes it. Data that no frame has taken are replaced by the
   * next ones, so that a scanner has no more than one command waiting.
   *
   * @param data as many bytes as it has
   */
  void write(String owner, int instance, ByteBuffer data) {
    Command command =
        instance == AssemblyPair.BUILT_IN_FROM_PLC
            ? new RtdeCommand.WriteInputs(owner, ControlAssembly.decode(data))
            : new AssemblyCommand.ReceiveAssembly(instance, AssemblyData.of(data));
    // no caller waits: data that find no place among the commands of a frame are followed by others
    newest.compute(
        owner,
        (_, before) -> {
          if (before != null) {
            before.withdraw();
          }
          return robot.post(command);
        });
  }

  /** Takes what an assembly writes; answers whether no other client has some of it. */
  boolean claim(String owner, int instance) throws InterruptedException {
    if (instance != AssemblyPair.BUILT_IN_FROM_PLC) {
      return true;
    }
    CompletableFuture<Set<String>> inUse = new CompletableFuture<>();
    // a box that does not answer gives nothing away, now or later
    Command claim = new RtdeCommand.ClaimInputs(owner, ControlAssembly.RECIPE, inUse::complete);
    return robot.ask(claim, Deadline.orNever(PATIENCE)) instanceof Reply.Done
        && inUse.getNow(ControlAssembly.RECIPE.names()).isEmpty();
  }

  /** Gives back what an owner has taken. */
  void release(String owner) throws InterruptedException {
    newest.remove(owner);
    var _ = robot.ask(new IoCommand.ReleaseSignals(owner), Deadline.orLater(PATIENCE));
  }

  /** The scanner that writes an assembly has gone; what follows is up to the installation. */
  void lost(String owner) {
    var _ = robot.submit(new InstallationCommand.ScannerLost(owner));
  }

  /** Makes a pair of assemblies; answers whether they are there. */
  boolean configure(AssemblyPair pair) throws InterruptedException {
    return robot.ask(new AssemblyCommand.ConfigureAssemblies(pair), Deadline.orNever(PATIENCE))
        instanceof Reply.Done;
  }
}
