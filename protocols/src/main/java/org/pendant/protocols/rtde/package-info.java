/**
 * Real-time data exchange (port 30004): clients choose which fields of the controller they get how
 * often, and which they write. Open {@link org.pendant.protocols.rtde.RtdeSession} first.
 */
package org.pendant.protocols.rtde;
