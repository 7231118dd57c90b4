package org.pendant.protocols.net;

import java.net.InetAddress;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Connection slots: the limited number of connections of one port. When all are taken, a new
 * connection replaces the one that has been silent for longest, so that peers which only stay
 * connected exclude no other; connections of the address that has most of them are replaced first.
 * Some slots are reserved for this computer itself. Any thread.
 */
final class ConnectionSlots<C extends Occupant> {
  /** One slot in so many is reserved for this computer. */
  private static final int RESERVED_OF = 16;

  /** A peer that has sent something keeps its slot for this long. */
  static final long SPOKEN_KEEPS_NS = TimeUnit.SECONDS.toNanos(60);

  private final int most;
  private final Set<C> occupants = new LinkedHashSet<>();

  /**
   * Admission of a new connection.
   *
   * @param taken whether it has a slot
   * @param givenUp the connection that it replaces
   */
  record Admission<C>(boolean taken, Optional<C> givenUp) {}

  /**
   * Free slots.
   *
   * @param most how many there are
   */
  ConnectionSlots(int most) {
    this.most = most;
  }

  /** Gives a new connection a slot, unless all are in use. */
  synchronized Admission<C> admit(C newcomer, long nowNs) {
    boolean full = occupants.size() >= most;
    boolean remoteFull = !local(newcomer) && remote() >= most - most / RESERVED_OF;
    if (!full && !remoteFull) {
      occupants.add(newcomer);
      return new Admission<>(true, Optional.empty());
    }
    Optional<C> silent = mostSilent(remoteFull, nowNs);
    if (silent.isPresent()) {
      occupants.remove(silent.get());
      occupants.add(newcomer);
    }
    return new Admission<>(silent.isPresent(), silent);
  }

  private Optional<C> mostSilent(boolean onlyRemote, long nowNs) {
    Map<InetAddress, Long> places =
        occupants.stream().collect(Collectors.groupingBy(Occupant::address, Collectors.counting()));
    Map<C, Silence> silences =
        occupants.stream()
            .filter(each -> !onlyRemote || !local(each))
            .collect(Collectors.toMap(Function.identity(), each -> each.silence(nowNs)));
    return silences.keySet().stream()
        .filter(each -> mayBeGivenUp(silences.get(each)))
        .min(
            Comparator.comparing((C each) -> places.get(each.address()), Comparator.reverseOrder())
                .thenComparing(each -> silences.get(each).kind())
                .thenComparing(each -> silences.get(each).lastsNs(), Comparator.reverseOrder()));
  }

  private static boolean mayBeGivenUp(Silence silence) {
    return silence.kind() != Silence.Kind.SPOKEN || silence.lastsNs() > SPOKEN_KEEPS_NS;
  }

  private long remote() {
    return occupants.stream().filter(each -> !local(each)).count();
  }

  private static boolean local(Occupant each) {
    return each.address().isLoopbackAddress();
  }

  /** Frees the slot of {@code occupant}. */
  synchronized void free(C occupant) {
    occupants.remove(occupant);
  }

  /** Whether any slot is taken. */
  synchronized boolean taken() {
    return !occupants.isEmpty();
  }

  /** The connections that have a slot, the oldest first. */
  synchronized List<C> occupants() {
    return List.copyOf(occupants);
  }
}
