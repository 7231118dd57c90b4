/**
 * Real-time interface (port 30003 and read-only 30013): one package of numbers in every frame. Open
 * {@link org.pendant.protocols.realtime.RealtimeServer} first.
 */
package org.pendant.protocols.realtime;
