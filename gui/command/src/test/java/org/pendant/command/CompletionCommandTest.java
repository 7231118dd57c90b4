package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class CompletionCommandTest {
  @TempDir Path folder;

  private static String script(String shell) {
    ByteArrayOutputStream output = new ByteArrayOutputStream();
    Console console = new Console(output, new ByteArrayOutputStream());
    assertEquals(ExitCode.DONE, new Pendant(console).run(List.of("completion", shell)));
    return output.toString(StandardCharsets.UTF_8);
  }

  /** What bash offers behind some words. */
  private List<String> bash(String... words) throws IOException, InterruptedException {
    Path file = folder.resolve("offer.bash");
    Files.writeString(
        file,
        script("bash")
            + "COMP_WORDS=(pendant \"$@\"); COMP_CWORD=$#\n_pendant\n"
            + "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
    List<String> command = new ArrayList<>(List.of("bash", file.toString()));
    command.addAll(List.of(words));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    String offered = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertTrue(process.waitFor(1, TimeUnit.MINUTES));
    return offered.strip().lines().toList();
  }

  @Test
  void bashOffersCommandsOptionsAndTheWordsOfAnOption() throws Exception {
    assertEquals(List.of("run", "render", "rpc", "record", "robots"), bash("r"));
    assertEquals(
        List.of("--seed", "--scene", "--safety", "--start-ramp"),
        bash("run", "a.script", "--s").stream().filter(each -> !each.equals("--speed")).toList());
    assertEquals(List.of("dynamic", "ideal"), bash("serve", "--arm", ""));
    assertEquals(List.of("ur5e"), bash("run", "--robot", "ur5e"));
    assertEquals(List.of(), bash("run", "exam"));
  }

  @Test
  void everyShellKnowsEveryOptionOfEveryCommand() {
    String bash = script("bash");
    String zsh = script("zsh");
    String fish = script("fish");
    Console console = new Console(new ByteArrayOutputStream(), new ByteArrayOutputStream());
    for (Subcommand each : new Pendant(console).subcommands()) {
      String name = each.name();
      List<String> options = new ArrayList<>(each.options().stream().map(Option::name).toList());
      options.add("--help");
      String inBash = "    " + name + ")\n      options='" + String.join(" ", options) + "'\n";
      assertTrue(bash.contains(inBash), name);
      String inZsh = zsh.substring(zsh.indexOf("    " + name + ")\n"));
      inZsh = inZsh.substring(0, inZsh.indexOf("_files' ;;"));
      for (String option : options) {
        assertTrue(inZsh.matches("(?s).*'\\*?" + option + "[=\\[].*"), name + " " + option);
        String inFish = "_from " + name + "' -l " + option.substring("--".length()) + " ";
        assertTrue(fish.contains(inFish), name + " " + option);
      }
    }
  }

  @Test
  void anotherShellIsRefused() {
    CompletionCommand command = new CompletionCommand(List::of);
    Console console = new Console(new ByteArrayOutputStream(), new ByteArrayOutputStream());
    assertEquals(
        "the shell is tcsh, must be bash, zsh or fish",
        assertThrows(
                UsageException.class,
                () -> command.run(Arguments.parse(List.of(), List.of("tcsh")), console))
            .getMessage());
  }
}
