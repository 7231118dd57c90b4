package org.pendant.command.doctor;

import static org.pendant.command.doctor.DoctorTexts.text;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Looks which ports of a control box are free on this computer, and who has the others. */
final class PortInspection implements Inspection {
  /** Below it systems may ask for more rights. */
  private static final int FIRST_FREE_FOR_ALL = 1024;

  private final List<StandardPort> ports;
  private final PortHolder holders;

  PortInspection(List<StandardPort> ports, PortHolder holders) {
    this.ports = List.copyOf(ports);
    this.holders = holders;
  }

  @Override
  public List<Finding> findings() {
    List<Finding> findings = new ArrayList<>();
    List<Integer> free = new ArrayList<>();
    for (StandardPort port : ports) {
      if (isFree(port)) {
        free.add(port.number());
      } else {
        findings.add(taken(port, holders.of(port)));
      }
    }
    if (!free.isEmpty()) {
      String numbers = String.join(" ", free.stream().distinct().map(String::valueOf).toList());
      findings.addFirst(Finding.ok(text("ports"), text("freePorts", numbers)));
    }
    return findings;
  }

  private static boolean isFree(StandardPort port) {
    InetSocketAddress place =
        new InetSocketAddress(InetAddress.getLoopbackAddress(), port.number());
    if (port.udp()) {
      try (DatagramSocket socket = new DatagramSocket(place)) {
        return socket.isBound();
      } catch (IOException e) {
        return false;
      }
    }
    try (ServerSocket socket = new ServerSocket()) {
      socket.bind(place);
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  /**
   * What is said of a port that cannot be opened.
   *
   * @param holder who has it, if that is told
   */
  static Finding taken(StandardPort port, Optional<PortHolder.Holder> holder) {
    FindingText subject = text("port", port.number());
    FindingText words = port.words();
    if (holder.isEmpty()) {
      return port.number() < FIRST_FREE_FOR_ALL
          ? Finding.note(
              subject,
              text("youMayNotOpenIt", port.protocol()),
              text("anotherPortIsOpened", port.number() + 1000))
          : problem(subject, text("takenByAnotherProgram", words, PortHolder.command(port)));
    }
    return switch (holder.get()) {
      case PortHolder.Self _ -> Finding.ok(subject, text("openedByThisPendant", words));
      case PortHolder.OtherUser _ -> problem(subject, text("takenByAnotherUser", words));
      case PortHolder.OtherProcess(String number, String name) when name.isEmpty() ->
          problem(subject, text("takenByProcess", words, number));
      case PortHolder.OtherProcess(String number, String name) ->
          problem(subject, text("takenByProgram", words, name, number));
    };
  }

  private static Finding problem(FindingText subject, FindingText found) {
    return Finding.problem(subject, found, text("endThatProgram"));
  }
}
