package org.pendant.command.doctor;

import static org.pendant.command.doctor.DoctorTexts.text;

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
        text("system"),
        FindingText.of(
            "%s %s, %s"
                .formatted(
                    System.getProperty("os.name"),
                    System.getProperty("os.version"),
                    System.getProperty("os.arch"))));
  }

  private static Finding java() {
    return Finding.ok(
        FindingText.of("Java"),
        text(
            "javaOfVendor",
            Runtime.version(),
            System.getProperty("java.vendor"),
            System.getProperty("java.home")));
  }

  private static Finding memory() {
    int processors = Runtime.getRuntime().availableProcessors();
    long memoryMib = Runtime.getRuntime().maxMemory() / MIB;
    return processors > 1
        ? Finding.ok(text("computer"), text("processors", processors, memoryMib))
        : Finding.note(
            text("computer"), text("oneProcessor", memoryMib), text("robotTimeMayFallBehind"));
  }

  private static Finding cache() {
    List<String> options = ManagementFactory.getRuntimeMXBean().getInputArguments();
    Optional<Path> cache =
        options.stream()
            .filter(each -> each.startsWith(CACHE))
            .map(each -> Path.of(each.substring(CACHE.length())))
            .findFirst();
    return cache.filter(Files::isReadable).isPresent()
        ? Finding.ok(text("fastStart"), text("fromCache", cache.get()))
        : Finding.note(text("fastStart"), text("noCache"), text("startsTakeLonger"));
  }
}
