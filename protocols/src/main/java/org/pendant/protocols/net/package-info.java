/**
 * Server basics: a TCP port that accepts and bounds connections, the thread that hands out frames,
 * and a log that a hostile peer cannot fill.
 */
package org.pendant.protocols.net;
