package org.pendant.desktop.tests;

import static org.pendant.desktop.tests.TestsTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.pendant.command.service.GoldenComparison;
import org.pendant.command.service.GoldenWriting;
import org.pendant.command.service.TestFinder;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.installation.InstallationProblem;
import org.pendant.recording.compare.TrackCurves;
import org.pendant.recording.compare.TrackDifference;
import org.pendant.testing.TestId;
import org.pendant.testing.run.Goldens;
import org.pendant.testing.source.GoldenMark;

/**
 * Folder files: the files of a folder as the window has them: those that are open with what is
 * edited in them, all others as they are on disk. Each is read once.
 */
final class FolderFiles implements TestSetup.Files {
  private static final int MAX_BYTES = 32 << 20;

  private final Path folder;
  private final Map<Path, byte[]> edited;
  private final Map<TestId, TrackCurves> differences = new ConcurrentHashMap<>();
  private final Map<String, byte[]> read = new ConcurrentHashMap<>();

  /**
   * Files of a folder.
   *
   * @param folder absolute
   * @param edited the content of files that are open, by their absolute paths
   */
  FolderFiles(Path folder, Map<Path, byte[]> edited) {
    this.folder = folder;
    this.edited = Map.copyOf(edited);
  }

  @Override
  public String folder() {
    return folder.toString();
  }

  @Override
  public List<String> find() throws IOException {
    return TestFinder.find(List.of(folder.toString())).stream()
        .map(each -> folder.relativize(Path.of(each)).toString().replace('\\', '/'))
        .toList();
  }

  @Override
  public boolean hasRead(String name) {
    return read.containsKey(name);
  }

  @Override
  public byte[] read(String name) throws IOException {
    byte[] known = read.get(name);
    if (known != null) {
      return known;
    }
    byte[] bytes = content(name);
    read.put(name, bytes);
    return bytes;
  }

  private byte[] content(String name) throws IOException {
    Path path;
    try {
      path = folder.resolve(name).normalize();
    } catch (InvalidPathException e) {
      throw new IOException(text("isNoNameOfAFile"), e);
    }
    byte[] open = edited.get(path);
    return open != null ? open : fromDisk(path);
  }

  private static byte[] fromDisk(Path path) throws IOException {
    byte[] bytes;
    try (InputStream in = Files.newInputStream(path)) {
      bytes = in.readNBytes(MAX_BYTES + 1);
    } catch (IOException e) {
      throw new IOException(FileTrouble.reason(e), e);
    }
    if (bytes.length > MAX_BYTES) {
      throw new IOException(text("hasMoreThanBytesNoProgram", MAX_BYTES));
    }
    return bytes;
  }

  @Override
  public Goldens goldens(boolean update) {
    return test -> {
      String name = GoldenComparison.name(test.id());
      GoldenMark mark = test.golden().orElseThrow();
      return update
          ? new GoldenWriting(name, this::golden, mark, _ -> {})
          : new GoldenComparison(name, new Compared(this, test.id()), mark);
    };
  }

  private Path golden(String name) {
    return folder.resolve(name).normalize();
  }

  /** Where the recording of a test is, and how the test differs from it. */
  private record Compared(FolderFiles all, TestId test) implements GoldenComparison.Place {
    @Override
    public Path file(String name) {
      return all.golden(name);
    }

    @Override
    public void differs(TrackDifference first, Path recording) {
      first.curves().ifPresent(curves -> all.differences.put(test, curves));
    }
  }

  @Override
  public Optional<TrackCurves> difference(TestId test) {
    return Optional.ofNullable(differences.get(test));
  }

  /** The arm stays that of the window. */
  @Override
  public ControllerOptions setUp(ControllerOptions base, Installation own, Optional<String> robot)
      throws IOException {
    Optional<InstallationProblem> refusal = InstallationCheck.refusal(own, base.arm());
    if (refusal.isPresent()) {
      throw new IOException(text("theRobotOfTheWindowCannot", refusal.get()));
    }
    return base.withInstallation(own);
  }

  @Override
  public ProgramsFolder folder(String name) {
    return ProgramsFolder.of(folder.resolve(name).toString());
  }
}
