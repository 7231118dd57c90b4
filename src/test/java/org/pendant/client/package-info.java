/**
 * A served box and the published clients that people use with it. Open {@link
 * org.pendant.client.RealClientsTest} first.
 */
package org.pendant.client;
