package org.pendant.command.doctor;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Port holder: the process that has a port of this computer. Linux tells by the files in {@code
 * /proc}; elsewhere it says with which command people ask.
 */
final class PortHolder {
  private static final String LISTENING = "0A";
  private static final String UNCONNECTED = "07";

  private static final int LOCAL_ADDRESS = 1;
  private static final int STATE = 3;
  private static final int INODE = 9;

  private final Path processes;

  PortHolder() {
    this(Path.of("/proc"));
  }

  PortHolder(Path processes) {
    this.processes = processes;
  }

  /** Who has a port. */
  sealed interface Holder {}

  /** This process itself. */
  record Self() implements Holder {}

  /**
   * A process that this user may look at.
   *
   * @param name of its program; empty where it has just ended
   */
  record OtherProcess(String number, String name) implements Holder {}

  /** A process of another user, of which the system tells no more. */
  record OtherUser() implements Holder {}

  /** Who it is; empty where nobody has it, or it is not told. */
  Optional<Holder> of(StandardPort port) {
    List<String> sockets = sockets(port);
    if (sockets.isEmpty()) {
      return Optional.empty();
    }
    try (DirectoryStream<Path> all = Files.newDirectoryStream(processes, "[0-9]*")) {
      for (Path process : all) {
        if (has(process, sockets)) {
          return Optional.of(holder(process));
        }
      }
    } catch (IOException e) {
      return Optional.empty();
    }
    return Optional.of(new OtherUser());
  }

  /** The command by which people ask where the holder is not known. */
  static String command(StandardPort port) {
    String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
    return system.startsWith("windows")
        ? "netstat -ano | findstr :" + port.number()
        : "lsof -nP -i :" + port.number();
  }

  /** Names of the sockets at a port, as the files of a process lead to them. */
  private List<String> sockets(StandardPort port) {
    List<String> sockets = new ArrayList<>();
    String kind = port.udp() ? "udp" : "tcp";
    String ending = String.format(":%04X", port.number());
    for (String table : List.of(kind, kind + "6")) {
      rows(table)
          .filter(row -> row.length > INODE && row[LOCAL_ADDRESS].endsWith(ending))
          .filter(row -> row[STATE].equals(port.udp() ? UNCONNECTED : LISTENING))
          .forEach(row -> sockets.add("socket:[" + row[INODE] + "]"));
    }
    return sockets;
  }

  /** Of the table of a kind of sockets; none where the system has no such table. */
  private Stream<String[]> rows(String table) {
    Path file = processes.resolve("net").resolve(table);
    try {
      return Files.readAllLines(file, StandardCharsets.US_ASCII).stream()
          .skip(1)
          .map(line -> line.strip().split("\\s+"));
    } catch (IOException e) {
      return Stream.empty();
    }
  }

  private static boolean has(Path process, List<String> sockets) {
    try (DirectoryStream<Path> files = Files.newDirectoryStream(process.resolve("fd"))) {
      for (Path file : files) {
        if (sockets.contains(target(file))) {
          return true;
        }
      }
      return false;
    } catch (IOException e) {
      // It belongs to somebody else, or has ended.
      return false;
    }
  }

  private static String target(Path file) {
    try {
      return Files.readSymbolicLink(file).toString();
    } catch (IOException e) {
      return "";
    }
  }

  private static Holder holder(Path process) {
    String number = process.getFileName().toString();
    if (number.equals(String.valueOf(ProcessHandle.current().pid()))) {
      return new Self();
    }
    try {
      return new OtherProcess(number, Files.readString(process.resolve("comm")).strip());
    } catch (IOException e) {
      return new OtherProcess(number, "");
    }
  }
}
