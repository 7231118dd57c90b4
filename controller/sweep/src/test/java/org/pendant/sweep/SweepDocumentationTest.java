package org.pendant.sweep;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** The program in Java of docs/sweeps.md: it compiles, and does what it says. */
@Tag("slow")
@Isolated("it takes the standard output of the whole JVM")
final class SweepDocumentationTest {
  private static final Pattern EXAMPLE =
      Pattern.compile("^```java\\n(.*?class (\\w+) .*?)^```$", Pattern.DOTALL | Pattern.MULTILINE);

  @TempDir private Path folder;

  /** The folder of the project, whichever module the tests are run in. */
  private static Path page() {
    Path at = Path.of("").toAbsolutePath();
    while (Files.notExists(at.resolve("docs/sweeps.md"))) {
      at = at.getParent();
    }
    return at.resolve("docs/sweeps.md");
  }

  private void compile(Path source) {
    int result =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                null,
                "-Xlint:all,-path",
                "-Werror",
                "-cp",
                System.getProperty("java.class.path"),
                "-d",
                folder.toString(),
                source.toString());
    assertEquals(0, result);
  }

  private List<String> run(String name, String... arguments)
      throws IOException, ReflectiveOperationException {
    PrintStream before = System.out;
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    System.setOut(new PrintStream(said, true, StandardCharsets.UTF_8));
    try (URLClassLoader loader =
        new URLClassLoader(new URL[] {folder.toUri().toURL()}, getClass().getClassLoader())) {
      Method main = loader.loadClass(name).getMethod("main", String[].class);
      main.invoke(null, (Object) arguments);
    } finally {
      System.setOut(before);
    }
    return said.toString(StandardCharsets.UTF_8).lines().toList();
  }

  @Test
  void theExampleRunsAPlanAndRecordsTheLongestRun()
      throws IOException, ReflectiveOperationException {
    Matcher example = EXAMPLE.matcher(Files.readString(page()));
    assertTrue(example.find(), "there is a program in Java");
    Path source = folder.resolve(example.group(2) + ".java");
    Files.writeString(source, example.group(1));
    compile(source);
    Files.writeString(folder.resolve("a.script"), "def a():\n  V = 1\n  sleep(V)\nend\n");
    Path plan = folder.resolve("p.toml");
    Files.writeString(
        plan,
        """
        program = "a.script"
        arm = "ideal"
        [[parameter]]
        set = "variable V"
        values = [0.1, 0.3, 0.2]
        """);
    Path out = folder.resolve("out");
    assertEquals(
        List.of("run 1 takes 0.302 s", out.resolve("kept/1.rec").toString()),
        run(example.group(2), plan.toString(), out.toString()));
  }
}
