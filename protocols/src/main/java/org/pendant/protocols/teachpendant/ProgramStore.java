package org.pendant.protocols.teachpendant;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.language.source.ByteText;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.urp.UrpxPrograms;
import org.pendant.protocols.teachpendant.StoreTrouble.Kind;
import org.pendant.script.value.ScriptError;

/**
 * Program store: programs of PolyScope X that clients put into the programs folder itself and take
 * out of it, by the names that the programs say in themselves. Any thread.
 */
public final class ProgramStore {
  /** Most bytes of a program: what is sent to a client has to fit into what may wait for it. */
  public static final int MAX_BYTES = 1_000_000;

  /** Most bytes of a name: with the ending it has to be one of a file. */
  private static final int MAX_NAME = 200;

  private final ProgramsFolder folder;
  private final ProgramRepository programRepository;

  /** One change of the folder at a time. */
  private final ReentrantLock changing = new ReentrantLock();

  ProgramStore(ProgramsFolder folder, ProgramRepository programRepository) {
    this.folder = folder;
    this.programRepository = programRepository;
  }

  /**
   * Adds a program.
   *
   * @param json of a {@code .urpx}
   * @return its name
   * @throws StoreTrouble if it is none, or one of that name is there, in whichever form
   */
  public String add(byte[] json) throws StoreTrouble {
    String name = name(json);
    changing.lock();
    try {
      Optional<Path> there = file(name);
      if (there.isPresent()) {
        throw exists(name, there.get());
      }
      if (programRepository.programs().size() >= ProgramRepository.MAX_LISTED) {
        throw new StoreTrouble(
            Kind.FULL,
            "the programs folder has "
                + ProgramRepository.MAX_LISTED
                + " programs, which are the most");
      }
      AtomicFile.create(root().resolve(name + UrpxPrograms.ENDING), out -> out.write(json));
      return name;
    } catch (IOException e) {
      throw failed(e);
    } finally {
      changing.unlock();
    }
  }

  /**
   * Replaces a program; one that is loaded stays as it was loaded.
   *
   * @param json of a {@code .urpx}
   * @return its name
   * @throws StoreTrouble if it is none, or none of that name is there, or one in another form
   */
  public String replace(byte[] json) throws StoreTrouble {
    String name = name(json);
    changing.lock();
    try {
      AtomicFile.write(foreign(name), json);
      return name;
    } catch (IOException e) {
      throw failed(e);
    } finally {
      changing.unlock();
    }
  }

  /**
   * A program as it is on disk.
   *
   * @throws StoreTrouble if there is none of that name, or one in another form
   */
  public byte[] read(String name) throws StoreTrouble {
    if (wrong(name).isPresent()) {
      throw missing(name);
    }
    try {
      var _ = foreign(name);
      return folder
          .find(ByteText.asBytes(name + UrpxPrograms.ENDING), UrpxPrograms.ENDING, MAX_BYTES)
          .read();
    } catch (ScriptError e) {
      throw new StoreTrouble(Kind.OTHER, ByteText.decoded(e.getMessage()));
    } catch (IOException e) {
      throw failed(e);
    }
  }

  private static String name(byte[] json) throws StoreTrouble {
    String name;
    try {
      name = UrpxPrograms.nameIn(json);
    } catch (UnreadableFile e) {
      throw new StoreTrouble(Kind.WRONG, e.told("file"));
    }
    Optional<String> wrong = wrong(name);
    if (wrong.isPresent()) {
      throw new StoreTrouble(Kind.WRONG, wrong.get());
    }
    return name;
  }

  /** Why no program may be called so: its name is that of a file in the folder itself. */
  private static Optional<String> wrong(String name) {
    boolean control = name.chars().anyMatch(Character::isISOControl);
    boolean reserved = name.chars().anyMatch(each -> "/\\:*?\"<>|".indexOf(each) >= 0);
    if (name.isBlank() || control || reserved) {
      return Optional.of(
          "the name of the program must not be empty and have no control characters and none of"
              + " / \\ : * ? \" < > |");
    }
    if (!name.equals(name.strip()) || name.startsWith(".") || name.endsWith(".")) {
      return Optional.of("the name of the program must not begin or end with a blank or a dot");
    }
    if (ProgramFile.isProgram(name)) {
      return Optional.of(
          "the name of the program must not end with " + String.join(", ", ProgramFile.ENDINGS));
    }
    int bytes = ByteText.asBytes(name).length();
    return bytes > MAX_NAME
        ? Optional.of(
            "the name of the program has " + bytes + " bytes, must have at most " + MAX_NAME)
        : Optional.empty();
  }

  private Path root() throws StoreTrouble, IOException {
    if (folder.folder().isEmpty()) {
      throw new StoreTrouble(Kind.FULL, "there is no programs folder");
    }
    return folder.folder().get().toRealPath();
  }

  /** The file that is meant by a name. */
  private Optional<Path> file(String name) throws StoreTrouble, IOException {
    Path root = root();
    try {
      return ProgramFile.ENDINGS.stream()
          .map(ending -> root.resolve(name + ending))
          // a link that leads nowhere is in the way as well
          .filter(each -> Files.exists(each, LinkOption.NOFOLLOW_LINKS))
          .findFirst();
    } catch (InvalidPathException e) {
      throw new StoreTrouble(Kind.WRONG, "no file can have the name of the program");
    }
  }

  /** The file of a program of PolyScope X, where links lead. */
  private Path foreign(String name) throws StoreTrouble, IOException {
    Path file = file(name).orElseThrow(() -> missing(name));
    if (!file.toString().endsWith(UrpxPrograms.ENDING) || !Files.isRegularFile(file)) {
      throw new StoreTrouble(
          Kind.OTHER, name + " is " + file.getFileName() + ", which is no program of PolyScope X");
    }
    Path real = file.toRealPath();
    if (!real.startsWith(root())) {
      throw new StoreTrouble(
          Kind.OTHER, file.getFileName() + " is a link that leads out of the programs folder");
    }
    return real;
  }

  private static StoreTrouble exists(String name, Path file) {
    return new StoreTrouble(Kind.EXISTS, name + " is there already, as " + file.getFileName());
  }

  private static StoreTrouble missing(String name) {
    return new StoreTrouble(
        Kind.MISSING,
        name + " is not there, with none of the endings " + String.join(", ", ProgramFile.ENDINGS));
  }

  private static StoreTrouble failed(IOException trouble) {
    return new StoreTrouble(Kind.FAILED, FileTrouble.reason(trouble));
  }
}
