package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.IntFunction;
import org.pendant.controller.eip.AssemblyPair;

/**
 * Assembly object: the assemblies as explicit messages read them: attribute 3 is the data, 4 their
 * size.
 */
final class AssemblyObject implements CipObject {
  private static final int DATA = 3;
  private static final int SIZE = 4;

  private final AssemblyHandler assemblyHandler;
  private final IntFunction<Optional<ByteBuffer>> received;

  /**
   * The assemblies of a box.
   *
   * @param received what a scanner has last written to the built-in assembly
   */
  AssemblyObject(AssemblyHandler assemblyHandler, IntFunction<Optional<ByteBuffer>> received) {
    this.assemblyHandler = assemblyHandler;
    this.received = received;
  }

  @Override
  public int revision() {
    return 2;
  }

  @Override
  public int highestInstance() {
    return assemblyHandler.image().pairs().stream()
        .mapToInt(pair -> Math.max(pair.toPlcId(), pair.fromPlcId()))
        .reduce(AssemblyPair.BUILT_IN_FROM_PLC, Math::max);
  }

  @Override
  public boolean has(int instance) {
    return size(instance).isPresent();
  }

  private OptionalInt size(int instance) {
    if (instance == AssemblyPair.CONFIGURATION) {
      return OptionalInt.of(0);
    }
    OptionalInt toScanner = assemblyHandler.toScannerBytes(instance);
    return toScanner.isPresent() ? toScanner : assemblyHandler.fromScannerBytes(instance);
  }

  @Override
  public Optional<ByteBuffer> attribute(int instance, int attribute) {
    return switch (attribute) {
      case DATA -> Optional.of(data(instance));
      case SIZE -> Optional.of(new LittleEndian().u16(size(instance).orElse(0)).toBuffer());
      default -> Optional.empty();
    };
  }

  private ByteBuffer data(int instance) {
    if (assemblyHandler.toScannerBytes(instance).isPresent()) {
      return assemblyHandler.toScanner(instance);
    }
    return assemblyHandler
        .image()
        .fromPlc(instance)
        .map(data -> ByteBuffer.wrap(data.toArray()))
        .or(() -> received.apply(instance))
        .orElseGet(() -> ByteBuffer.allocate(size(instance).orElse(0)));
  }
}
