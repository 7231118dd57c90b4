package org.pendant;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.command.Launcher;

/**
 * The Java runtime of the packages has the modules named in {@code .build/packages/modules} alone:
 * a class of another one is missing only where it is first used.
 */
@Tag("slow")
final class PackagedRuntimeTest {
  private static final Path HOME = Launcher.home();

  @Test
  void itHasEveryModuleThatPendantsClassesNeed() throws IOException {
    List<String> words =
        new ArrayList<>(List.of("-s", "--multi-release", "base", "--ignore-missing-deps"));
    classes().forEach(each -> words.add(each.toString()));
    StringWriter found = new StringWriter();
    int code =
        ToolProvider.findFirst("jdeps")
            .orElseThrow()
            .run(new PrintWriter(found), new PrintWriter(found), words.toArray(String[]::new));
    assertEquals(0, code, found.toString());

    Set<String> needed = new TreeSet<>();
    Pattern.compile("-> (java\\.\\S+|jdk\\.\\S+)")
        .matcher(found.toString())
        .results()
        .forEach(each -> needed.add(each.group(1)));
    assertTrue(needed.contains("java.desktop"), found.toString());
    String packaged = Files.readString(HOME.resolve(".build/packages/modules")).strip();
    needed.removeAll(Arrays.asList(packaged.split(",")));
    // What these two require themselves.
    needed.removeAll(List.of("java.base", "java.datatransfer"));
    assertEquals(Set.of(), needed, "modules that .build/packages/modules lacks");
  }

  /** Folders of compiled classes, below their {@code module-info}; Spark is in no package. */
  private static List<Path> classes() throws IOException {
    try (Stream<Path> files =
        Files.find(
            HOME,
            5,
            (file, _) ->
                file.endsWith("target/classes/org")
                    && !file.startsWith(HOME.resolve("gui/spark")))) {
      return files.sorted().toList();
    }
  }
}
