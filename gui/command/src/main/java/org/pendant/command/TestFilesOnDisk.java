package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.Installation;
import org.pendant.language.source.Source;
import org.pendant.testing.source.TestSources;

/** Test files on the disk, each read once. Any thread may ask. */
final class TestFilesOnDisk implements TestSources {
  private static final int MAX_BYTES = 32 << 20;

  private final Arguments arguments;
  private final SourceFiles files;
  private final Map<String, Source> read = new ConcurrentHashMap<>();

  /**
   * Files on the disk.
   *
   * @param arguments remember what is read, so that no report is written onto it, and say what
   *     robots are like
   */
  TestFilesOnDisk(Arguments arguments) {
    this.arguments = arguments;
    files = arguments.files();
  }

  @Override
  public byte[] read(String name) throws IOException {
    Source known = read.get(name);
    if (known != null) {
      return known.bytes();
    }
    byte[] bytes = fromDisk(name);
    read.put(name, Source.of(name, bytes));
    return bytes;
  }

  private byte[] fromDisk(String name) throws IOException {
    Path path;
    synchronized (files) {
      try {
        path = files.path("aFileOfTheTests", name);
      } catch (UsageException e) {
        throw new IOException(e.getMessage(), e);
      }
    }
    try (InputStream in = Files.newInputStream(path)) {
      byte[] bytes = in.readNBytes(MAX_BYTES + 1);
      if (bytes.length > MAX_BYTES) {
        throw new IOException(text("tooLargeForProgram", MAX_BYTES));
      }
      return bytes;
    } catch (IOException e) {
      throw e.getMessage() != null && e.getMessage().startsWith("has more")
          ? e
          : new IOException(FileTrouble.reason(e), e);
    }
  }

  /**
   * Where the recording is that a test is compared with.
   *
   * @throws IOException if that is no name of a file
   */
  Path golden(String name) throws IOException {
    synchronized (files) {
      try {
        return files.path("aRecordingOfTheTests", name);
      } catch (UsageException e) {
        throw new IOException(e.getMessage(), e);
      }
    }
  }

  @Override
  public ControllerOptions setUp(ControllerOptions base, Installation own, Optional<String> robot)
      throws IOException {
    synchronized (files) {
      try {
        return RunOptions.of(arguments, Optional.of(own), robot).controller().withSeed(base.seed());
      } catch (UsageException e) {
        throw new IOException(e.getMessage(), e);
      }
    }
  }

  @Override
  public ProgramsFolder folder(String name) {
    return ProgramsFolder.of(name);
  }

  /** The files that were read. */
  Set<String> names() {
    return Set.copyOf(read.keySet());
  }

  /** The text of a file that was read. */
  Optional<Source> source(String name) {
    return Optional.ofNullable(read.get(name));
  }
}
