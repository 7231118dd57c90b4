/**
 * What if: the panel in which people run a program once more with other speeds, loads and texts,
 * and compare what comes of it. Open {@link org.pendant.desktop.whatif.WhatIfView} first.
 */
package org.pendant.desktop.whatif;
