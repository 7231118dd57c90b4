package org.pendant.controller.file;

import static org.pendant.controller.file.FileTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.script.value.ScriptError;

/**
 * Programs folder: takes the place of the real controller's {@code /programs}: the only one from
 * which scripts can read. Immutable; any thread may ask.
 *
 * @param folder empty when there is none
 */
public record ProgramsFolder(Optional<Path> folder) {
  /** No folder: every file is refused. */
  public static final ProgramsFolder NONE = new ProgramsFolder(Optional.empty());

  /** How the folder is called in scripts. */
  public static final String ROOT = "/programs/";

  private static final String REFUSED = "file-refused";

  /** The folder at a path. */
  public static ProgramsFolder at(Path path) {
    return new ProgramsFolder(Optional.of(path));
  }

  /** The folder that holds a program's file, or none for a text without a file. */
  public static ProgramsFolder of(String programFile) {
    try {
      Path file = Path.of(programFile).toAbsolutePath();
      return Files.isRegularFile(file) ? at(file.getParent()) : NONE;
    } catch (InvalidPathException e) {
      return NONE;
    }
  }

  /**
   * Finds a file.
   *
   * @param bytes its name as scripts hold it, one {@code char} a byte of UTF-8: relative to the
   *     folder, or beginning with {@value #ROOT}
   * @param ending of the name, with its dot, in lower case
   * @param largestBytes how large it may be
   * @throws ScriptError when it is not there, not below the folder, too large, or no such file
   */
  public Found find(String bytes, String ending, long largestBytes) throws ScriptError {
    String name = new String(bytes.getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
    if (folder.isEmpty()) {
      throw refused(name, "noFolder");
    }
    if (!name.toLowerCase(Locale.ROOT).endsWith(ending)) {
      throw refused(name, "ending", ending);
    }
    String inside = name.startsWith(ROOT) ? name.substring(ROOT.length()) : name;
    if (inside.startsWith("/") || inside.indexOf('\\') >= 0 || inside.indexOf(':') >= 0) {
      throw refused(name, "outside", ROOT);
    }
    if (List.of(inside.split("/", -1)).contains("..")) {
      throw refused(name, "leadsOut");
    }
    try {
      Path root = folder.get().toRealPath();
      Path file = root.resolve(inside).toRealPath();
      if (!file.startsWith(root)) {
        throw refused(name, "linkLeadsOut");
      }
      if (!Files.isRegularFile(file)) {
        throw refused(name, "noFile");
      }
      long size = Files.size(file);
      if (size > largestBytes) {
        throw tooLarge(name, largestBytes);
      }
      return new Found(name, file, size, largestBytes);
    } catch (IOException | InvalidPathException e) {
      throw refused(name, e);
    }
  }

  private static ScriptError refused(String name, Exception e) {
    return switch (e) {
      case NoSuchFileException _ -> refused(name, "missing");
      case NotDirectoryException _ -> refused(name, "missing");
      case AccessDeniedException _ -> refused(name, "noPermission");
      case InvalidPathException _ -> refused(name, "noFileName");
      case FileSystemException refused when refused.getReason() != null ->
          refused(name, "unreadable", refused.getReason());
      default -> refused(name, "unreadable", e.getClass().getSimpleName());
    };
  }

  private static ScriptError refused(String name, String key) {
    return new ScriptError(REFUSED, text(key, shown(name)));
  }

  private static ScriptError refused(String name, String key, Object value) {
    return new ScriptError(REFUSED, text(key, shown(name), value));
  }

  private static ScriptError tooLarge(String name, long largestBytes) {
    return refused(name, "tooLarge", largestBytes);
  }

  private static String shown(String name) {
    return "\"" + (name.length() > 80 ? name.substring(0, 80) + "..." : name) + "\"";
  }

  /** A file below the folder, as it was when it was found. */
  public static final class Found {
    private final String name;
    private final Path file;
    private final long sizeBytes;
    private final long largestBytes;

    private Found(String name, Path file, long sizeBytes, long largestBytes) {
      this.name = name;
      this.file = file;
      this.sizeBytes = sizeBytes;
      this.largestBytes = largestBytes;
    }

    /** The last part of its name, for messages. */
    public String shortName() {
      return file.getFileName().toString();
    }

    /** How large it is. */
    public long sizeBytes() {
      return sizeBytes;
    }

    /**
     * All of it; may take long, so not for the frame loop unless the file is small.
     *
     * @throws ScriptError when it cannot be read, or has grown too large
     */
    public byte[] read() throws ScriptError {
      try (InputStream in = Files.newInputStream(file)) {
        byte[] bytes = in.readNBytes((int) Math.min(Integer.MAX_VALUE - 8, largestBytes + 1));
        if (bytes.length > largestBytes) {
          throw tooLarge(name, largestBytes);
        }
        return bytes;
      } catch (IOException e) {
        throw refused(name, e);
      }
    }
  }
}
