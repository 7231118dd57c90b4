/**
 * Primary and secondary interfaces (ports 30001, 30002 and read-only 30011, 30012): the state ten
 * times a second, and messages as things happen. Open {@link
 * org.pendant.protocols.primary.PrimaryServer} first.
 */
package org.pendant.protocols.primary;
