package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestStatus;

class TutorialTest {
  private static final Pattern BLOCK =
      Pattern.compile("```urscript[^\n]*\n(.*?)```", Pattern.DOTALL);

  @Test
  void theTestsOfTheTutorialPass() throws IOException {
    String page = Files.readString(Path.of("../../docs/testing-tutorial.md"));
    List<String> scripts = new ArrayList<>();
    Matcher block = BLOCK.matcher(page);
    while (block.find()) {
      scripts.add(block.group(1));
    }

    SuiteResult result =
        Suite.of(String.join("\n", scripts.subList(1, scripts.size())))
            .with("cell/pick.script", scripts.getFirst())
            .run();

    assertEquals(List.of(), result.broken());
    assertEquals(List.of(), result.results().stream().filter(each -> each.status().red()).toList());
    assertEquals(7, result.count(TestStatus.PASSED));
    assertEquals(1, result.count(TestStatus.SKIPPED));
  }
}
