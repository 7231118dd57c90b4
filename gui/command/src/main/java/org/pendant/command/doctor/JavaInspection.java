package org.pendant.command.doctor;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Looks at the Java that runs this, and at what makes it start fast. */
final class JavaInspection implements Inspection {
  private static final String CACHE = "-XX:AOTCache=";
  private static final long MIB = 1 << 20;

  @Override
  public List<Finding> findings() {
    return List.of(system(), java(), memory(), cache());
  }

  private static Finding system() {
    return Finding.ok(
        "System",
        "%s %s, %s"
            .formatted(
                System.getProperty("os.name"),
                System.getProperty("os.version"),
                System.getProperty("os.arch")));
  }

  private static Finding java() {
    return Finding.ok(
        "Java",
        "%s of %s, %s"
            .formatted(
                Runtime.version(),
                System.getProperty("java.vendor"),
                System.getProperty("java.home")));
  }

  private static Finding memory() {
    Runtime runtime = Runtime.getRuntime();
    String found =
        "%d processors, %d MB for Pendant"
            .formatted(runtime.availableProcessors(), runtime.maxMemory() / MIB);
    return runtime.availableProcessors() > 1
        ? Finding.ok("Computer", found)
        : Finding.note(
            "Computer",
            found.replace("processors", "processor"),
            "robot time may fall behind in the window; runs without one only take longer");
  }

  private static Finding cache() {
    List<String> options = ManagementFactory.getRuntimeMXBean().getInputArguments();
    Optional<Path> cache =
        options.stream()
            .filter(each -> each.startsWith(CACHE))
            .map(each -> Path.of(each.substring(CACHE.length())))
            .findFirst();
    return cache.filter(Files::isReadable).isPresent()
        ? Finding.ok("Fast start", "from " + cache.get())
        : Finding.note(
            "Fast start",
            "no cache of classes is in use",
            "every start takes up to a second longer; the pendant command makes the cache where it"
                + " may write beside itself");
  }
}
