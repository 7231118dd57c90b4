package org.pendant.protocols.panel;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import org.pendant.controller.Controller;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.machine.Loaded;
import org.pendant.controller.value.ScriptError;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.DiagnosticFormat;
import org.pendant.language.source.Source;

/** Reads programs and installations from the programs folder. Any thread. */
final class ProgramShelf {
  private static final long LARGEST_BYTES = 32 << 20;
  private static final String SCRIPT = ".script";
  private static final String URP = ".urp";
  private static final String INSTALLATION = ".installation";

  private final ProgramsFolder folder;
  private final Controller controller;

  ProgramShelf(ProgramsFolder folder, Controller controller) {
    this.folder = folder;
    this.controller = controller;
  }

  /**
   * Reads and compiles a program.
   *
   * @param bytes name of a {@code .script} or {@code .urp} file, one {@code char} a byte: relative
   *     to the folder, below {@code /programs/}, or with the folder's own path
   */
  LoadedProgram load(String bytes) throws LoadTrouble {
    String name = inside(bytes);
    String lower = name.toLowerCase(Locale.ROOT);
    if (lower.endsWith(SCRIPT)) {
      return compiled(name, name, "");
    }
    if (!lower.endsWith(URP)) {
      throw new LoadTrouble(
          true, bytes + " cannot be loaded: it must be the name of a .urp or .script file");
    }
    return urp(name);
  }

  private LoadedProgram urp(String name) throws LoadTrouble {
    UrpFile urp;
    try {
      urp = UrpFile.read(read(name, URP));
    } catch (IOException e) {
      throw new LoadTrouble(false, name + " is not a program: it " + e.getMessage());
    }
    String script = name.substring(0, name.length() - URP.length()) + SCRIPT;
    try {
      folder.find(script, SCRIPT, LARGEST_BYTES);
    } catch (ScriptError e) {
      throw new LoadTrouble(
          false,
          name
              + " cannot be run without the script that is saved beside it ("
              + e.getMessage()
              + "); it has the nodes "
              + String.join(", ", urp.nodes().stream().sorted().toList()));
    }
    return compiled(name, script, urp.installation());
  }

  /** Compiles {@code script}, and calls it {@code name} from then on. */
  private LoadedProgram compiled(String name, String script, String installation)
      throws LoadTrouble {
    Source source = Source.of(lastPart(script), read(script, SCRIPT));
    Loaded loaded = controller.load(source);
    if (loaded.program().isEmpty()) {
      String why =
          loaded.diagnostics().stream()
              .filter(Diagnostic::isError)
              .findFirst()
              .map(each -> firstLine(DiagnosticFormat.format(source, each)))
              .orElse("it does not compile");
      throw new LoadTrouble(false, why);
    }
    if (loaded.program().get().secondary()) {
      throw new LoadTrouble(false, script + " is a secondary program, which cannot be played");
    }
    return new LoadedProgram(
        lastPart(name), ProgramsFolder.ROOT + name, loaded.program().get(), installation, true);
  }

  /** Makes sure that there is an installation; answers its name below the folder. */
  String installation(String bytes) throws LoadTrouble {
    String name = inside(bytes);
    byte[] content = read(name, INSTALLATION);
    if (content.length == 0) {
      throw new LoadTrouble(false, name + " is empty");
    }
    return name;
  }

  private byte[] read(String name, String ending) throws LoadTrouble {
    ProgramsFolder.Found found;
    try {
      found = folder.find(name, ending, LARGEST_BYTES);
    } catch (ScriptError e) {
      throw new LoadTrouble(true, e.getMessage());
    }
    try {
      return found.read();
    } catch (ScriptError e) {
      throw new LoadTrouble(false, e.getMessage());
    }
  }

  /** The name below the folder, however it was written. */
  private String inside(String bytes) {
    String name = bytes.strip();
    if (name.startsWith(ProgramsFolder.ROOT)) {
      return name.substring(ProgramsFolder.ROOT.length());
    }
    String own = folder.folder().map(ProgramShelf::asBytes).orElse("");
    return !own.isEmpty() && name.startsWith(own) ? name.substring(own.length()) : name;
  }

  private static String asBytes(Path path) {
    byte[] bytes = (path.toAbsolutePath() + "/").getBytes(StandardCharsets.UTF_8);
    return new String(bytes, StandardCharsets.ISO_8859_1);
  }

  private static String lastPart(String name) {
    return name.substring(name.lastIndexOf('/') + 1);
  }

  private static String firstLine(String text) {
    return text.lines().findFirst().orElse("");
  }
}
