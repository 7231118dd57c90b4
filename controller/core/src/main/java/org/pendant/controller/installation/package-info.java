/**
 * Installation: how one robot is set up: what is mounted on it, what its signals mean, where things
 * stand. Open {@link org.pendant.controller.installation.Installation} first.
 */
package org.pendant.controller.installation;
