package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.command.launch.StartKind;

/** The command of the packages, installed with a Java that only says how it was called. */
@EnabledOnOs(OS.LINUX)
final class InstalledLauncherTest {
  private static final int PATIENCE_S = 60;

  @TempDir Path folder;
  private Path prefix;
  private Path library;

  @BeforeEach
  void install() throws IOException {
    prefix = folder.resolve("opt/a pendant");
    library = prefix.resolve("lib/pendant");
    Files.createDirectories(prefix.resolve("bin"));
    Files.createDirectories(library.resolve("runtime/bin"));
    Path build = Launcher.home().resolve(".build");
    Files.copy(build.resolve("packages/bin/pendant"), prefix.resolve("bin/pendant"));
    Files.copy(build.resolve("packages/bin/prepare"), library.resolve("prepare"));
    Files.copy(build.resolve("options.sh"), library.resolve("options.sh"));
    Files.copy(build.resolve("start.sh"), library.resolve("start.sh"));
    Files.writeString(library.resolve("build"), "0123456789abcdef\n");
    Path java = library.resolve("runtime/bin/java");
    Files.writeString(
        java,
        "#!/bin/sh\n[ -z \"$DISPLAY\" ] || { echo \"$*\"; exit; }\nfor word; do case $word in"
            + " -XX:AOTCacheOutput=*) echo recorded >\"${word#*=}\";;"
            + " -XX:AOTCache=*) echo \"with ${word##*/}\";;"
            + " -XX:ErrorFile=*) crashes=${word#*=};;"
            + " crashes) echo \"$crashes\";;"
            + " -jar) runs=1;; esac; done\n"
            + "[ -z \"$runs\" ] || echo \"${word}\"\n");
    Files.setPosixFilePermissions(java, PosixFilePermissions.fromString("rwx------"));
  }

  private String run(Path command, String... words) throws IOException, InterruptedException {
    return run("", command, words);
  }

  /** Where there is a {@code display}, Java only says with which words it is called. */
  private String run(String display, Path command, String... words)
      throws IOException, InterruptedException {
    String[] line = new String[words.length + 1];
    line[0] = command.toString();
    System.arraycopy(words, 0, line, 1, words.length);
    ProcessBuilder builder = new ProcessBuilder(line).redirectErrorStream(true);
    builder.environment().put("DISPLAY", display);
    builder.environment().remove("WAYLAND_DISPLAY");
    builder.environment().put("XDG_CACHE_HOME", folder.resolve("user").toString());
    builder.environment().put("XDG_STATE_HOME", folder.resolve("my state").toString());
    Process process = builder.start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS), "it ends");
    assertEquals(0, process.exitValue(), said);
    return said;
  }

  @Test
  void itStartsWithTheCacheThatTheInstallationHasForTheCommand() throws Exception {
    Files.createDirectories(library.resolve("caches"));
    run(library.resolve("prepare"), library.resolve("caches").toString(), "pendant", "editors");
    Path link = Files.createSymbolicLink(folder.resolve("pendant"), prefix.resolve("bin/pendant"));

    assertEquals("with pendant.aot\n--version\n", run(link, "--version"));
    assertEquals("with editors.aot\nlsp\n", run(link, "lsp"));
    assertFalse(Files.exists(folder.resolve("user")));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "run a.script",
        "--version",
        "open a.script",
        "open --help",
        "--robot ur10e",
        "missing.script",
        "lsp",
        "dap",
        "sweep plan.toml",
        "sweep plan.toml --engine spark"
      })
  void theShellChoosesOptionsAndCacheAsJavaDoes(String line) throws Exception {
    List<String> words = List.of(line.split(" "));
    StartKind kind = StartKind.of(words, true, each -> Files.isRegularFile(Path.of(each)));
    Files.createDirectories(library.resolve("caches"));
    Files.writeString(library.resolve("caches").resolve(kind.cache() + ".aot"), "a cache");

    List<String> expected = new ArrayList<>();
    expected.add("-XX:ErrorFile=" + folder.resolve("my state/pendant/hs_err_pid%p.log"));
    expected.addAll(kind.all(List.of(), "Linux"));
    expected.add("-Dpendant.end-at-once=true");
    expected.add("-XX:AOTCache=" + library.resolve("caches").resolve(kind.cache() + ".aot"));
    expected.addAll(List.of("-jar", library.resolve("app/pendant.jar").toString()));
    expected.addAll(words);

    assertEquals(
        String.join(" ", expected) + "\n",
        run(":7", prefix.resolve("bin/pendant"), words.toArray(String[]::new)));
  }

  @Test
  void whatPreparingCouldNotRecordIsLeftOut() throws Exception {
    Files.createDirectories(library.resolve("caches"));
    Files.writeString(library.resolve("caches/pendant.aot"), "");

    assertEquals("--version\n", run(prefix.resolve("bin/pendant"), "--version"));
  }

  @Test
  void theCacheOfAnInstallationThatCannotBeWrittenIsTheUsersAndOfThisVersion() throws Exception {
    Files.createSymbolicLink(library.resolve("caches"), folder.resolve("nowhere"));
    Path old = Files.createDirectories(folder.resolve("user/pendant/fedcba9876543210"));
    Files.writeString(old.resolve("pendant.aot"), "old");
    Path own = folder.resolve("user/pendant/0123456789abcdef");

    run(library.resolve("prepare"), own.toString(), "pendant");

    assertEquals("with pendant.aot\n--version\n", run(prefix.resolve("bin/pendant"), "--version"));
    assertFalse(Files.exists(old.resolve("pendant.aot")));
  }

  @Test
  void aJvmThatCrashesLeavesItsLogWhereTheLogsAre() throws Exception {
    Files.createDirectories(library.resolve("caches"));
    Files.writeString(library.resolve("caches/pendant.aot"), "");

    assertEquals(
        folder.resolve("my state/pendant/hs_err_pid%p.log") + "\ncrashes\n",
        run(prefix.resolve("bin/pendant"), "crashes"));
    assertTrue(Files.isDirectory(folder.resolve("my state/pendant")));
  }

  @Test
  void whereTheFolderOfLogsCannotBeTheJvmChoosesAPlace() throws Exception {
    Files.createDirectories(library.resolve("caches"));
    Files.writeString(library.resolve("caches/pendant.aot"), "");
    Files.writeString(folder.resolve("my state"), "a file");

    assertEquals("\ncrashes\n", run(prefix.resolve("bin/pendant"), "crashes"));
  }

  @Test
  void preparingDeletesNothingBesideAFolderThatPeopleChoose() throws Exception {
    Path other = Files.createDirectories(folder.resolve("pendant/other"));
    Files.writeString(other.resolve("mine.aot"), "mine");

    run(library.resolve("prepare"), folder.resolve("pendant/chosen").toString(), "pendant");

    assertTrue(Files.exists(folder.resolve("pendant/chosen/pendant.aot")));
    assertFalse(Files.exists(folder.resolve("pendant/chosen/lock")));
    assertEquals("mine", Files.readString(other.resolve("mine.aot")));
  }
}
