"""Messages of apt, bash, coreutils, make, git and gcc in other languages are read as the English ones."""
# ruff: noqa: RUF001 - the signs of these languages are what is tested

from __future__ import annotations

import io

import pytest

from roslab.explain.answer import explain

APT = "apt-get update && apt-get install -y arm-core"
CASES = {
    "de release": (
        "E: Das Depot »http://apt.example.org/tools bionic-tools Release« enthält keine Release-Datei.",
        APT,
    ),
    "fr release": ("E: Le dépôt http://apt.example.org/tools bionic-tools Release n'a pas de fichier Release.", APT),
    "es release": (
        "E: El repositorio «http://apt.example.org/tools bionic-tools Release» no tiene un fichero de Publicación.",
        APT,
    ),
    "zh release": ("E: 仓库 “http://apt.example.org/tools bionic-tools Release” 没有 Release 文件。", APT),
    "it release": ('E: Il repository "http://apt.example.org/tools bionic-tools Release" non ha un file Release.', APT),
    "de candidate": ("E: Für Paket »arm-core« existiert kein Installationskandidat", APT),
    "es candidate": ("E: El paquete «arm-core» no tiene un candidato para la instalación", APT),
    "zh candidate": ("E: 软件包 arm-core 没有可安装候选", APT),
    "it package": ("E: Impossibile trovare il pacchetto arm-core", APT),
    "ko package": ("E: arm-core 패키지를 찾을 수 없습니다", APT),
    "pt package": ("E: Impossível encontrar o pacote arm-core", APT),
    "zh depends": ("arm-core : 依赖: libarm1.13 但无法安装它\nE: 无法修正错误，因为您要求某些软件包保持现状", APT),
    "es depends": (
        "arm-core : Depende: libarm1.13 pero no es instalable\nE: No se pudieron corregir los problemas",
        APT,
    ),
    "de depends": ("arm-core : Hängt ab von: libarm2 (= 2.1) aber 2.3 soll installiert werden\nE: Probleme", APT),
    "zh command": ("/bin/bash: 第 1 行：colcon：未找到命令", "colcon build"),
    "es command": ("/bin/bash: línea 1: colcon: orden no encontrada", "colcon build"),
    "fr command": ("/bin/bash : ligne 1 : colcon : commande introuvable", "colcon build"),
    "ru command": ("bash: строка 1: colcon: команда не найдена", "colcon build"),
    "de stat": (
        "cp: der Aufruf von stat für 'arm.yaml' ist nicht möglich: Datei oder Verzeichnis nicht gefunden",
        "cp arm.yaml /etc",
    ),
    "zh stat": ("cp: 对 'arm.yaml' 调用 stat 失败: 没有那个文件或目录", "cp arm.yaml /etc"),
    "it stat": ("cp: impossibile eseguire stat di 'arm.yaml': File o directory non esistente", "cp arm.yaml /etc"),
    "zh make": ("make[2]: *** 没有规则可制作目标“arm/arm.pb.h”，由“arm.o” 需求。 停止。", "make"),
    "es make": (
        "make: *** No hay ninguna regla para construir el objetivo 'arm/arm.pb.h', necesario para 'arm.o'.  Alto.",
        "make",
    ),
    "zh git": ("fatal: 仓库 'https://github.com/acme/arm.git/' 未找到", "git clone https://github.com/acme/arm.git"),
    "de branch": (
        "fatal: Remote-Branch devel nicht im Upstream-Repository origin gefunden",
        "git clone -b devel https://github.com/acme/arm.git",
    ),
    "zh member": ("/ws/src/a.cpp:15:25: 错误：‘turn’不是‘arm::Joint’的成员", "make"),
    "zh has": ("/ws/src/a.cpp:15:25: 错误：‘class arm::Joint’没有名为‘turn’的成员", "make"),
    "zh call": ("/ws/src/a.cpp:15:25: 错误：对‘arm::Joint::turn(double&)’的调用没有匹配的函数", "make"),
}
KNOWN = {
    "release": "repository-dropped-release",
    "candidate": "apt-unknown",
    "package": "apt-unknown",
    "depends": "apt-conflict",
    "command": "program-missing",
    "stat": "file-missing",
    "make": "make-no-rule",
    "git": "git-repository-gone",
    "branch": "git-ref-gone",
    "member": "api-member",
    "has": "api-member",
    "call": "api-call",
}


@pytest.mark.parametrize("case", CASES)
def test_a_message_in_another_language_has_the_cause_of_the_english_one(case: str) -> None:
    said, command = CASES[case]
    lines = "\n".join(
        f"#8 1.{at} {line}" for at, line in enumerate(["Fetched 900 kB in 1s (900 kB/s)", *said.split("\n")])
    )
    end = f'#8 ERROR: process "/bin/sh -c {command}" did not complete successfully: exit code: 2'
    log = f"#8 [3/4] RUN {command}\n{lines}\n{end}\n"
    assert [found.id for found in explain(io.BytesIO(log.encode())).explanations] == [KNOWN[case.partition(" ")[2]]]
