package org.pendant.desktop.session;

import java.io.IOException;
import java.net.URI;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.pendant.controller.disk.AtomicFile;

/**
 * Open files: which files the windows of a user have open: each window says so in a file of its
 * own, in a folder that all of them know. What windows that are no more have left there is taken
 * away. It reads and writes, so not in the dispatch thread.
 */
public final class OpenFiles implements AutoCloseable {
  private static final String HEADING = "pendant open files 1";
  private static final String ENDING = ".open";

  /** Far above what any window has open. */
  private static final long MAX_BYTES = 1 << 20;

  private final Path folder;
  private final Owner self;
  private final Predicate<Owner> alive;
  private final Path own;
  private Set<URI> told = Set.of();
  private boolean closed;

  /** Those of a new window of this process. */
  public OpenFiles(Path folder) {
    this(folder, Owner.self(), Owner::alive);
  }

  OpenFiles(Path folder, Owner self, Predicate<Owner> alive) {
    this.folder = folder;
    this.self = self;
    this.alive = alive;
    // A process may have several windows.
    own =
        folder.resolve(self.process() + "-" + self.startedMs() + "-" + UUID.randomUUID() + ENDING);
  }

  /**
   * Tells the other windows which files are open in this one.
   *
   * @return those of them that another window has open as well
   * @throws IOException if what is open cannot be told, or that of others cannot be read
   */
  public synchronized List<Path> share(Collection<Path> open) throws IOException {
    if (closed) {
      return List.of();
    }
    tell(open);
    Set<URI> others = others();
    return open.stream().filter(each -> others.contains(nameOf(each))).toList();
  }

  private void tell(Collection<Path> open) throws IOException {
    Set<URI> now = new TreeSet<>();
    open.forEach(each -> now.add(nameOf(each)));
    if (now.equals(told) && (now.isEmpty() || Files.exists(own))) {
      return;
    }
    List<String> lines = new ArrayList<>(List.of(HEADING, self.toString()));
    now.forEach(each -> lines.add(each.toString()));
    AtomicFile.write(own, String.join("\n", lines).getBytes(StandardCharsets.UTF_8));
    told = now;
  }

  /** Links lead to the file itself; one that is not there yet has its name only. */
  private static URI nameOf(Path file) {
    try {
      return file.toRealPath().toUri();
    } catch (IOException e) {
      return file.toAbsolutePath().normalize().toUri();
    }
  }

  private Set<URI> others() throws IOException {
    Set<URI> all = new HashSet<>();
    try (Stream<Path> files = Files.list(folder)) {
      for (Path each : files.filter(path -> path.toString().endsWith(ENDING)).toList()) {
        if (!each.equals(own)) {
          all.addAll(read(each));
        }
      }
    } catch (NoSuchFileException e) {
      // No window has anything open.
      return Set.of();
    }
    return all;
  }

  private Set<URI> read(Path other) throws IOException {
    try {
      if (Files.size(other) > MAX_BYTES) {
        return Set.of();
      }
      List<String> lines = Files.readAllLines(other);
      Optional<Owner> owner =
          lines.size() < 2 || !lines.getFirst().equals(HEADING)
              ? Optional.empty()
              : Owner.parse(lines.get(1));
      if (owner.isEmpty()) {
        return Set.of();
      }
      if (!alive.test(owner.get())) {
        Files.deleteIfExists(other);
        return Set.of();
      }
      Set<URI> files = new HashSet<>();
      for (String line : lines.subList(2, lines.size())) {
        files.add(URI.create(line));
      }
      return files;
    } catch (NoSuchFileException e) {
      // Its window was closed this very moment.
      return Set.of();
    } catch (CharacterCodingException | IllegalArgumentException e) {
      // It is none of ours.
      return Set.of();
    }
  }

  /** The window is closed: nothing is open in it any more. */
  @Override
  public synchronized void close() throws IOException {
    closed = true;
    Files.deleteIfExists(own);
  }
}
