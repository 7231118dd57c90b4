package org.pendant.desktop.ports;

import java.util.List;
import org.pendant.protocols.trace.Peers;

/**
 * Client row: one client of the ports, in words.
 *
 * @param connected for how long
 * @param in what comes from it each second
 * @param out what goes to it each second
 * @param data how often it gets data that it has asked for; empty for none
 * @param waiting what it has not read, and what was left out for that; empty for nothing
 * @param reads names of the data that it gets
 * @param writes names of what only it may write
 */
record ClientRow(
    Peers peers,
    String connected,
    String in,
    String out,
    String data,
    String waiting,
    List<String> reads,
    List<String> writes) {
  ClientRow {
    reads = List.copyOf(reads);
    writes = List.copyOf(writes);
  }
}
