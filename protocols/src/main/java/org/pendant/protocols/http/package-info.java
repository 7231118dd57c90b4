/**
 * HTTP servers and what they have in common: requests of known length, one answer to each. Open
 * {@link org.pendant.protocols.http.HttpSession} first.
 */
package org.pendant.protocols.http;
